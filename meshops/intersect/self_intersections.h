// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Pairs of faces that have more in common than shared vertices and edges, in ascending order, by exact
/// predicates; faces that only touch are included.
std::vector<std::array<Face, 2>> self_intersections(const Mesh& mesh);

}  // namespace sherd
