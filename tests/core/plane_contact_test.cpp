// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/plane_contact.h"

#include <gtest/gtest.h>

#include "core/time_step.h"
#include "tests/support/finite_differences.h"
#include "tests/support/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

/// A lone vertex, which a step treats as a ball of mass 0.1 kg.
Sheet ball(double height) {
    Sheet sheet;
    resize_vertices(sheet, 1);
    sheet.position.col(0) = Vector3d(0, 0, height);
    sheet.rest = sheet.position;
    sheet.mass[0] = 0.1;
    sheet.thickness[0] = 0.01;
    sheet.young[0] = 1e7;
    sheet.footprint[0] = 1e-4;
    return sheet;
}

Plane floor_with_friction(double friction) {
    return {Vector3d::Zero(), Vector3d::UnitZ(), 1e7, friction};
}

// Sticking, sliding, touching and free: forces and their derivatives, friction included.
TEST(PlaneContact, ForceAndStiffnessAreDerivativesOfTheValue) {
    Random random(1);
    Sheet sheet = ball(0.0049);
    Plane plane = floor_with_friction(0.4);
    plane.normal = Vector3d(0.1, 0.2, 1).normalized();
    const PlaneContact contact(sheet, plane, 1e-3);
    for (int i = 0; i < 100; ++i) {
        const double way = i % 2 ? 3e-5 : 2e-6;  // beyond and below the smoothing
        const Vector3d x = Vector3d(sheet.position.col(0)) + random.matrix<Vector3d>(way);
        const auto value = [&](const Vector3d& at) { return contact.value(Positions(at)); };
        const auto gradient = [&](const Vector3d& at) {
            Positions sum = Positions::Zero(3, 1);
            contact.add_gradient(Positions(at), sum);
            return Vector3d(sum.col(0));
        };
        const Vector3d exact = gradient(x);
        EXPECT_LT((exact - test::difference_gradient(value, x, 1e-8)).norm(), 1e-5 * exact.norm());
        BlockMatrix hessian(1, {}, {0});
        contact.add_hessian(Positions(x), Curvature::exact, hessian);
        Matrix3d numeric = test::difference_hessian(gradient, x, 1e-9);
        const auto values = hessian.values();
        EXPECT_NEAR(values[0], numeric(0, 0), 1e-4 * numeric.norm());
        EXPECT_NEAR(values[1], numeric(1, 0), 1e-4 * numeric.norm());
        EXPECT_NEAR(values[4], numeric(2, 1), 1e-4 * numeric.norm());
        EXPECT_NEAR(values[5], numeric(2, 2), 1e-4 * numeric.norm());
    }
}

// The spring of a resting vertex is the two materials in series over the footprint.
TEST(PlaneContact, RestingWeightSinksInAsTheTwoMaterialsSay) {
    Sheet sheet = ball(0.005);
    TimeStepOptions options;
    options.step = 1e-3;
    options.planes = {floor_with_friction(0)};
    options.newton.tolerance = 1e-14;
    TimeStep step(sheet, options);
    for (int i = 0; i < 4000; ++i) {
        step.begin();
        step.solve(20);
        step.finish();
    }
    const double stiffness = 1e-4 / 0.01 / (2 / 1e7);
    EXPECT_NEAR(0.005 - sheet.position(2, 0), 0.1 * 9.81 / stiffness, 1e-9);
    EXPECT_EQ(step.contacts(), 1);
}

// Coulomb: a = mu g, until it stops after v^2 / (2 mu g).
TEST(PlaneContact, FrictionStopsASlidingVertexAfterTheCoulombDistance) {
    Sheet sheet = ball(0.005 - 0.1 * 9.81 / 5e4);
    sheet.velocity(0, 0) = 1;
    TimeStepOptions options;
    options.step = 1e-4;
    options.planes = {floor_with_friction(0.5)};
    options.newton.tolerance = 1e-13;
    TimeStep step(sheet, options);
    for (int i = 0; i < 4000; ++i) {
        step.begin();
        step.solve(20);
        step.finish();
    }
    const double distance = 1 / (2 * 0.5 * 9.81);
    EXPECT_NEAR(sheet.position(0, 0), distance, 0.01 * distance);
    EXPECT_LT(sheet.velocity.col(0).norm(), 1e-3);
}

}  // namespace
}  // namespace sherd
