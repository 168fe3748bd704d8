// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/edge_moment.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sherd {
namespace {

using Turned = TurnedTriangles::Turned;

/// Weights of the triangle's vertices in the vector from the foot of its height to its apex.
Vector3d weights(const Turned& triangle) {
    return {triangle.foot - 1, -triangle.foot, 1};
}

Vector2d arm(const Turned& triangle, const TrianglePositions& x) {
    return triangle.across * (x * weights(triangle));
}

}  // namespace

std::vector<EdgeMoment> edge_moments(const Shell& shell, std::span<const TriangleEdge> sides, double moment) {
    std::vector<EdgeMoment> moments;
    for (const TriangleEdge& side : sides) {
        const auto [from, to, apex] = edge_and_apex(shell, side);
        const Vector3d way = shell.rest.col(to) - shell.rest.col(from);
        moments.push_back({side, way.normalized(), moment * way.norm()});
    }
    return moments;
}

Turned turned_triangle(const Shell& shell, const EdgeMoment& moment, double share) {
    Turned triangle;
    triangle.vertices = edge_and_apex(shell, moment.side);
    const TrianglePositions rest = columns(shell.rest, triangle.vertices);
    const Vector3d along = rest.col(1) - rest.col(0);
    triangle.foot = along.dot(rest.col(2) - rest.col(0)) / along.squaredNorm();
    triangle.across.row(0) = moment.axis.unitOrthogonal();
    triangle.across.row(1) = moment.axis.cross(Vector3d(triangle.across.row(0)));
    triangle.start = arm(triangle, columns(shell.position, triangle.vertices));
    triangle.moment = share * moment.moment;
    return triangle;
}

double TurnedTriangles::value(std::size_t i, const TrianglePositions& x) const {
    const Turned& triangle = triangles[i];
    const Vector2d &a = triangle.start, b = arm(triangle, x);
    return -triangle.moment * std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

TrianglePositions TurnedTriangles::gradient(std::size_t i, const TrianglePositions& x) const {
    const Turned& triangle = triangles[i];
    const Vector2d b = arm(triangle, x), turn = Vector2d(-b.y(), b.x()) / b.squaredNorm();
    return -triangle.moment * triangle.across.transpose() * turn * weights(triangle).transpose();
}

Eigen::Matrix<double, 9, 9> TurnedTriangles::hessian(std::size_t i, const TrianglePositions& x,
                                                     Curvature curvature) const {
    Eigen::Matrix<double, 9, 9> blocks = Eigen::Matrix<double, 9, 9>::Zero();
    if (curvature == Curvature::convex) return blocks;
    const Turned& triangle = triangles[i];
    const Vector2d b = arm(triangle, x);
    const double mixed = b.y() * b.y() - b.x() * b.x(), product = 2 * b.x() * b.y();
    Eigen::Matrix2d of_angle;
    of_angle << product, mixed, mixed, -product;
    const Matrix3d of_arm = -triangle.moment / (b.squaredNorm() * b.squaredNorm()) *
                            triangle.across.transpose() * of_angle * triangle.across;
    const Vector3d weight = weights(triangle);
    for (int v = 0; v < 3; ++v)
        for (int w = 0; w < 3; ++w) blocks.block<3, 3>(3 * v, 3 * w) = weight[v] * weight[w] * of_arm;
    return blocks;
}

}  // namespace sherd
