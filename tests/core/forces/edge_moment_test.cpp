// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/edge_moment.h"

#include <numbers>

#include "core/forces/loads.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

using std::numbers::pi;

/// Moments on two sides of a pair of triangles, at random positions.
struct Moments {
    Shell shell = test::two_triangles(Material{});
    Load load;
    Moments() {
        load.moments = edge_moments(shell, std::vector<TriangleEdge>{{0, 1}, {1, 1}}, 3);
        test::Random random(5);
        for (double& entry : shell.position.reshaped()) entry += random.uniform(-0.2, 0.2);
    }
};

// With wrong derivatives Newton's method would not converge, or would find a wrong shape.
TEST(EdgeMoment, GradientAndHessianAreDerivatives) {
    Moments moments;
    LoadEnergy energy(moments.shell, {moments.load});
    energy.begin({});
    test::Random random(6);
    Positions x = moments.shell.position;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.2, 0.2);
    test::expect_derivatives(energy, x, 1e-4, 1e-7);
}

// The forces of a moment must have no sum, and their couple about the side must be the given one, at any
// angle.
TEST(EdgeMoment, IsACoupleOfItsSizeAboutItsSide) {
    Shell shell = test::two_triangles(Material{});
    const TriangleEdge side{0, 1};
    const auto [from, to, apex] = edge_and_apex(shell, side);
    const Vector3d edge = shell.rest.col(to) - shell.rest.col(from), middle = shell.rest.col(from);
    Load load;
    load.moments = edge_moments(shell, std::vector{side}, -2.5);
    LoadEnergy energy(shell, {load});
    energy.begin({});
    for (const double angle : {0.0, 0.5, 3.0}) {
        Positions x = shell.rest;
        const Eigen::AngleAxisd turn(angle, edge.normalized());
        x.col(apex) = turn * (x.col(apex) - middle) + middle;
        Positions gradient = Positions::Zero(3, 4);
        energy.add_gradient(x, gradient);
        EXPECT_LT(gradient.rowwise().sum().norm(), 1e-12);
        Vector3d torque = Vector3d::Zero();
        for (int v = 0; v < 4; ++v) torque -= Vector3d(x.col(v)).cross(Vector3d(gradient.col(v)));
        EXPECT_LT((torque + 2.5 * edge).norm(), 1e-12) << "N m per m of the side";
        EXPECT_NEAR(energy.value(x), 2.5 * edge.norm() * angle, 1e-12) << "minus its work";
    }
}

// Over several turns the energy must continue from the angle at the end of the last step.
TEST(EdgeMoment, CountsFromTheBeginningOfTheStep) {
    Shell shell = test::two_triangles(Material{});
    const std::array<Index, 3> corners = edge_and_apex(shell, {0, 1});
    const Index apex = corners[2];
    const Vector3d middle = shell.rest.col(corners[0]), edge = shell.rest.col(corners[1]) - middle;
    const auto turned = [&](double angle) {
        Positions x = shell.rest;
        x.col(apex) = Eigen::AngleAxisd(angle, edge.normalized()) * (x.col(apex) - middle) + middle;
        return x;
    };
    Load load;
    load.moments = edge_moments(shell, std::vector<TriangleEdge>{{0, 1}}, 1);
    LoadEnergy energy(shell, {load});
    shell.position = turned(0.9 * pi);
    energy.begin({});
    EXPECT_NEAR(energy.value(turned(1.1 * pi)), -0.2 * pi * edge.norm(), 1e-12);
}

}  // namespace
}  // namespace sherd
