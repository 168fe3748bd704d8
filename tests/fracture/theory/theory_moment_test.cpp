// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

/// Mean position of the end of a cantilever of length 1 m and rigidity 1 N m, once it has come to rest under
/// a moment (N m/m) or a force along -z (N/m) on this end.
Vector3d tip(double moment, double force) {
    const Material material = test::unit_plate(0, 0.01);
    BreakableShell strip = test::flat_plate(1, 0.25, 0.05, material);
    Shell& shell = strip.mechanics();
    const std::vector<char> end = test::select(shell, [](const Vector3d& x) { return x.x() > 1 - 1e-9; });
    StepperOptions options;
    options.gravity.setZero();
    options.step = 10;
    options.shell.mirrors =
        test::clamp(shell, test::select(shell, [](const Vector3d& x) { return x.x() < 1e-9; }),
                    hinge_stiffness(material));
    Load load;
    load.moments = edge_moments(shell, boundary_triangle_edges(shell, end), moment);
    load.dead = line_forces(shell, boundary_triangle_edges(shell, end), Vector3d(0, 0, -force));
    options.shell.loads = {load};
    test::settle(shell, options, 30);
    Vector3d sum = Vector3d::Zero();
    double count = 0;
    for (Eigen::Index v = 0; v < shell.mass.size(); ++v) {
        if (!end[v]) continue;
        sum += shell.position.col(v);
        ++count;
    }
    return sum / count;
}

// By the right-hand rule about +y an end moment bends the strip away from its normal, by M l^2 / 2 D. Hinges
// are too compliant (docs/theory/bending.md): by how much, the deflection F l^3 / 3 D under a force shows.
TEST(EdgeMoment, BendsACantileverAsMuchAsAForceDoes) {
    const double by_moment = -tip(0.1, 0).z() / (0.1 / 2), by_force = -tip(0, 0.1).z() / (0.1 / 3);
    EXPECT_NEAR(by_moment, 1, 0.2) << "beside beam theory";
    EXPECT_NEAR(by_moment / by_force, 1, 0.025);
}

// A moment that does not change with the angle of the end must bend the strip to a circular arc.
TEST(EdgeMoment, BendsACantileverToACircle) {
    const double moment = 0.8, curvature = moment * -tip(0.1, 0).z() / (0.1 / 2);
    const Vector3d end = tip(moment, 0);
    EXPECT_NEAR(end.x(), std::sin(curvature) / curvature, 0.03);
    EXPECT_NEAR(end.z(), -(1 - std::cos(curvature)) / curvature, 0.03);
}

}  // namespace
}  // namespace sherd
