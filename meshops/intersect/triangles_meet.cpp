// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/triangles_meet.h"

#include <CGAL/intersections.h>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using TriangleCorners = std::array<Eigen::Vector3d, 3>;

/// Whether the bounding boxes of two triangles are apart, which settles most pairs at little cost.
bool boxes_part(const TriangleCorners& a, const TriangleCorners& b) {
    const auto lower = [](const TriangleCorners& c) { return c[0].cwiseMin(c[1]).cwiseMin(c[2]).eval(); };
    const auto upper = [](const TriangleCorners& c) { return c[0].cwiseMax(c[1]).cwiseMax(c[2]).eval(); };
    return (lower(a).array() > upper(b).array()).any() || (lower(b).array() > upper(a).array()).any();
}

/// Whether the side of the triangle `of` that is opposite to its first corner meets the triangle `other`.
bool side_meets(const TriangleCorners& of, const TriangleCorners& other) {
    const Kernel::Triangle_3 triangle(point_at(other[0]), point_at(other[1]), point_at(other[2]));
    const Kernel::Segment_3 side(point_at(of[1]), point_at(of[2]));
    return !triangle.is_degenerate() && !side.is_degenerate() && CGAL::do_intersect(side, triangle);
}

}  // namespace

bool triangles_meet(const TrianglePair& pair) {
    const auto& [a, b, shared] = pair;
    if (shared > 1 || boxes_part(a, b)) return false;
    if (shared == 1) return side_meets(a, b) || side_meets(b, a);
    const Kernel::Triangle_3 one(point_at(a[0]), point_at(a[1]), point_at(a[2]));
    const Kernel::Triangle_3 other(point_at(b[0]), point_at(b[1]), point_at(b[2]));
    return !one.is_degenerate() && !other.is_degenerate() && CGAL::do_intersect(one, other);
}

}  // namespace sherd
