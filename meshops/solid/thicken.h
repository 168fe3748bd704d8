// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Thickens the sheet to a closed body, oriented outward: point i becomes i (on the side that the normals
/// point to) and P + i (on the other), triangle t becomes t and, with opposite orientation, T + t, followed
/// by two triangles for each boundary edge, in the order of triangles and of their sides. Each connected part
/// becomes a body of its own. Triangles keep their properties except normals. Those along a boundary
/// edge take the properties of its triangle there, and are shaded as a rim. thickness: [T] m.
///
/// Points are offset along the normal weighted by angle, so far that the area-weighted mean of the distances
/// from the triangles around the point is half the thickness (at a fold the offset is longer, up to twice):
/// the volume is area times thickness up to terms of curvature squared.
///
/// origin: [P] or empty; points with the same origin were one vertex before a crack split it. While they are
/// closer than half the thickness and their normals differ by less than 20 degrees, they are offset in the
/// same direction. While they are closer than 1 % of the thickness this holds up to 90 degrees, and each
/// moves back from the crack by half of that distance, so that the sides of a closed crack neither touch nor
/// intersect.
TriangleSheet thickened(const TriangleSheet& sheet, std::span<const double> thickness,
                        std::span<const std::int32_t> origin = {});

}  // namespace sherd
