// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Component number of each face, indexed by face; faces are in one component when they share an edge.
/// Components are numbered in the order of their first face.
struct Components {
    std::vector<std::int32_t> of_face;
    std::int32_t count = 0;
};

Components connected_components(const Mesh& mesh);

}  // namespace sherd
