// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/write_mesh.h"

namespace sherd {

/// The sheet as a closed body with its outside to the outside: point i becomes i (the side that the normals
/// point to) and P + i (the other), triangle t becomes t and, turned over, T + t, and two triangles for each
/// boundary edge follow; each connected part is a body of its own. Group and quality go with the triangles;
/// texture, axes and named groups do not. thickness: [T] m.
///
/// The sides stand off along the normal weighted by angle, so far that the distances from the triangles
/// around the point, weighted by area, are half the thickness in the mean (at a fold the offset is longer
/// than that, but at most twice as long): the volume is area times thickness but for terms of curvature
/// squared.
///
/// origin: [P] or empty; points of the same origin were one before a crack passed. While they are closer than
/// half the thickness and have turned by less than 20 degrees they stand off in the same direction. While
/// they are closer than 1 % of the thickness they do so up to 90 degrees, and each moves back from the crack
/// by half of that: the sides of a closed crack neither touch nor cut into each other.
TriangleSheet thickened(const TriangleSheet& sheet, std::span<const double> thickness,
                        std::span<const std::int32_t> origin = {});

}  // namespace sherd
