// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Thickens a sheet of P points and T triangles to a closed body, oriented outward. Point i of the sheet
/// becomes point i of the body, on the side that the normals point to, and point P + i on the other side.
/// Triangle t becomes triangle t and, with opposite orientation, triangle T + t. Two triangles for each
/// boundary edge follow, in the order of the sheet's triangles and of their sides. Each connected part of the
/// sheet becomes a body of its own. Triangles of the body have the properties, except normals, of the sheet's
/// triangles that they come from; triangles along a boundary edge have those of the sheet's triangle there,
/// and are shaded as a rim. thickness: [T] m.
///
/// A point is offset along the mean of the normals of the triangles around it, weighted by angle. The offset
/// is so long that the distances of the offset point from the planes of these triangles have half the
/// thickness as their mean, weighted by area. At a fold the offset is therefore longer, up to the thickness.
/// The volume of the body is the sheet's area times the thickness, up to terms of curvature squared.
///
/// origin: [P] or empty; points with the same origin were one vertex before a crack split it. If such points
/// are closer to each other than half the thickness, and their normals differ by less than 20 degrees, they
/// are offset in the same direction. If they are closer than 1 % of the thickness, a difference of up to 90
/// degrees is allowed, and each of them moves back from the crack by 0.5 % of the thickness, so that the
/// sides of a closed crack neither touch nor intersect.
TriangleSheet thickened(const TriangleSheet& sheet, std::span<const double> thickness,
                        std::span<const std::int32_t> origin = {});

}  // namespace sherd
