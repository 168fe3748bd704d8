// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Pairs of faces that have more in common than the vertices and edges they share, in ascending order, by
/// exact predicates; faces that only touch count, too.
std::vector<std::array<Face, 2>> self_intersections(const Mesh& mesh);

}  // namespace sherd
