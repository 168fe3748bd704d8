// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/mid_edge.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sherd {
namespace {

/// A side, with a frame at its middle.
struct Side {
    Vector2d along, outward;  ///< unit vectors
    double length;            ///< m
    double apex, height;      ///< m; the opposite corner is at (apex, -height) in this frame
};

Side side_of(const PlaneTriangle& triangle, int side) {
    const Vector2d from = triangle.corners.col((side + 1) % 3), to = triangle.corners.col((side + 2) % 3);
    Side s;
    s.length = (to - from).norm();
    s.along = (to - from) / s.length;
    s.outward = {s.along.y(), -s.along.x()};
    s.apex = s.along.dot(triangle.corners.col(side) - 0.5 * (from + to));
    s.height = 2 * triangle.area / s.length;
    return s;
}

}  // namespace

PlaneTriangle plane_triangle(const TrianglePositions& rest) {
    const Vector3d edge = rest.col(1) - rest.col(0), side = rest.col(2) - rest.col(0);
    const double length = edge.norm(), twice_area = edge.cross(side).norm();
    PlaneTriangle triangle;
    triangle.corners << 0, length, side.dot(edge) / length, 0, 0, twice_area / length;
    triangle.area = 0.5 * twice_area;
    return triangle;
}

double height_over_side(const PlaneTriangle& triangle, int side) {
    return side_of(triangle, side).height;
}

double direction_of_side(const PlaneTriangle& triangle, int side) {
    const Vector2d along = side_of(triangle, side).along;
    return std::atan2(along.y(), along.x());
}

Vector3d tangent_angle(const PlaneTriangle& triangle, int side) {
    const auto [t, n, l, d, h] = side_of(triangle, side);
    const double nn = h / 2, tn = -d, tt = (d * d - l * l / 4) / (2 * h);
    return {nn * n[0] * n[0] + tn * t[0] * n[0] + tt * t[0] * t[0],
            nn * n[1] * n[1] + tn * t[1] * n[1] + tt * t[1] * t[1],
            nn * n[0] * n[1] + tn / 2 * (t[0] * n[1] + t[1] * n[0]) + tt * t[0] * t[1]};
}

Vector3d curvature_of_tangent(const PlaneTriangle& triangle, int side) {
    const Side s = side_of(triangle, side);
    const Vector2d& n = s.outward;
    return s.length / triangle.area * Vector3d(n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]);
}

Vector3d turned_tensor(const Vector3d& tensor, double angle) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    Eigen::Matrix2d full;
    full << tensor[0], tensor[2], tensor[2], tensor[1];
    full = (turn * full * turn.transpose()).eval();
    return {full(0, 0), full(1, 1), full(0, 1)};
}

}  // namespace sherd
