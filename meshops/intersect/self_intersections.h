// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Returns the pairs of faces that intersect or touch elsewhere than at vertices and edges that they share,
/// by exact predicates. The pairs are in ascending order, each with its lower face first.
std::vector<std::array<Face, 2>> self_intersections(const Mesh& mesh);

}  // namespace sherd
