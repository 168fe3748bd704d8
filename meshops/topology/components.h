// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Number of the component of each face. Faces are in one component if they are connected through edges.
/// Components are numbered in the order of their first faces.
struct Components {
    std::vector<std::int32_t> of_face;
    std::int32_t count = 0;
};

Components connected_components(const Mesh& mesh);

}  // namespace sherd
