// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/rim_load.h"

#include <array>

#include "app/bench/shell/face_moments.h"

namespace sherd {
namespace {

constexpr double on_rectangle = 1e-9;  // m, largest distance from a rectangle of a point on it

struct RimSide {
    double length;
    Vector2d along, outward;

    RimSide(const Shell& shell, const TriangleEdge& side) {
        const auto [from, to, apex] = edge_and_apex(shell, side);
        const Vector2d way = (shell.rest.col(to) - shell.rest.col(from)).head<2>();
        length = way.norm();
        along = way / length;
        outward = {along.y(), -along.x()};
        if (outward.dot(middle_of(shell, side)) < 0) outward = -outward;
    }
};

}  // namespace

Vector2d middle_of(const Shell& shell, const TriangleEdge& side) {
    const auto [from, to, apex] = edge_and_apex(shell, side);
    return (0.5 * (shell.rest.col(from) + shell.rest.col(to))).head<2>();
}

void add_rim_stress(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& stress, Load& load) {
    const RimSide rim(shell, side);
    Vector3d force = Vector3d::Zero();
    force.head<2>() = 0.5 * rim.length * (stress * rim.outward);
    for (const int end : {1, 2}) load.dead.push_back({side.triangle, (side.corner + end) % 3, force});
}

void add_rim_moments(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& moments,
                     const Vector2d& shear, Load& load) {
    const RimSide rim(shell, side);
    const double twist = rim.outward.dot(moments * rim.along);
    const double half = shear.dot(rim.outward) * rim.length / 2;
    for (const EdgeMoment& one : edge_moments(
             shell, std::array{side}, side_of(shell, side.triangle) * rim.outward.dot(moments * rim.outward)))
        load.moments.push_back(one);
    load.dead.push_back({side.triangle, (side.corner + 1) % 3, {0, 0, half + twist}});
    load.dead.push_back({side.triangle, (side.corner + 2) % 3, {0, 0, half - twist}});
}

std::vector<char> on_bounding_rectangle(const Shell& shell) {
    const Vector2d lower = shell.rest.topRows<2>().rowwise().minCoeff(),
                   upper = shell.rest.topRows<2>().rowwise().maxCoeff();
    std::vector<char> on(shell.rest.cols());
    for (Index v = 0; v < shell.rest.cols(); ++v) {
        const Vector2d at = shell.rest.col(v).head<2>();
        on[v] = std::min((at - lower).minCoeff(), (upper - at).minCoeff()) < on_rectangle;
    }
    return on;
}

}  // namespace sherd
