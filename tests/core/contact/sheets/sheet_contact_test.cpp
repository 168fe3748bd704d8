// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheets/sheet_contact.h"

#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

Positions shaken(const Positions& x, double amplitude) {
    test::Random random(6);
    Positions moved = x;
    for (double& entry : moved.reshaped()) entry += random.uniform(-amplitude, amplitude);
    return moved;
}

// Wrong derivatives would push sheets wrongly or keep Newton's method from converging. More than a hundred
// pairs of all cases act at once, also edges that are nearly parallel.
TEST(SheetContact, ForceAndStiffnessAreDerivativesOfTheValue) {
    const Shell shell = test::stacked_plates(2, 5, 1.8e-3, test::ceramic);
    const SheetContact contact(shell);
    const Positions x = shaken(shell.position, 1e-4);
    ASSERT_GT(contact.active_pairs(x).size(), 100u);
    Positions sum = Positions::Zero(3, x.cols());
    contact.add_gradient(x, sum);
    EXPECT_GT(sum.norm(), 1);
    EXPECT_LT(sum.rowwise().sum().norm(), 1e-12 * sum.norm());
    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < x.cols(); ++v) torque += x.col(v).cross(sum.col(v));
    EXPECT_LT(torque.norm(), 1e-12 * sum.norm());
    test::expect_derivatives(contact, x, 1e-10, 2e-6);
}

// Candidates are found once for a neighbourhood of positions and used again: after queries inside it,
// outside and inside again, an object must give the same bits as a new one.
TEST(SheetContact, DoesNotDependOnWhereItWasAskedBefore) {
    const Shell shell = test::stacked_plates(3, 4, 1.8e-3, test::ceramic);
    const SheetContact wanderer(shell);
    for (const double lift : {0.0, 0.02, 0.0, 1.0, 0.05, 1e-3}) {
        Positions x = shaken(shell.position, 1e-4);
        x.row(2) *= 1 + lift;
        const SheetContact fresh(shell);
        EXPECT_EQ(wanderer.value(x), fresh.value(x));
        Positions a = Positions::Zero(3, x.cols()), b = a;
        wanderer.add_gradient(x, a);
        fresh.add_gradient(x, b);
        EXPECT_EQ(a, b);
        for (const double length : {1e-5, 1e-3, 0.01, 1.0}) {
            Positions motion = shaken(Positions::Zero(3, x.cols()), 0.1 * length);
            motion.row(0).head(motion.cols() / 2).array() += length;  // half of the vertices move along x
            EXPECT_EQ(wanderer.safe_fraction(x, motion), SheetContact(shell).safe_fraction(x, motion));
        }
        EXPECT_EQ(wanderer.value(x), fresh.value(x));
    }
}

// A sheet whose edges are shorter than its thickness must not push itself apart at rest, but must where it
// is folded flat.
TEST(SheetContact, RestShapeIsFreeOfForces) {
    Material thick = test::rubber;
    thick.thickness = 0.03;
    Shell shell = test::stacked_plates(1, 10, 0, thick);  // edges of 0.01 m
    const SheetContact contact(shell);
    EXPECT_EQ(contact.active_pairs(shell.position).size(), 0u);
    EXPECT_EQ(contact.value(shaken(shell.position, 5e-4)), 0);
    Positions folded = shell.position;
    for (Index v = 0; v < folded.cols(); ++v)
        if (folded(0, v) > 0) {
            folded(2, v) = 0.005 + 0.1 * folded(0, v);
            folded(0, v) = -folded(0, v);
        }
    EXPECT_GT(contact.active_pairs(folded).size(), 100u);
}

/// Area, m^2, common to two squares of side 0.1 m that are turned against each other by 0.7 rad, from a grid
/// of points.
double common_area() {
    int inside = 0;
    for (int i = 0; i < 400; ++i)
        for (int j = 0; j < 400; ++j) {
            const Vector3d at((i + 0.5) / 400 - 0.5, (j + 0.5) / 400 - 0.5, 0);
            inside += (Eigen::AngleAxisd(0.7, Vector3d::UnitZ()) * at).cwiseAbs().maxCoeff() < 0.5;
        }
    return 0.01 * inside / 160000;
}

// Plates that lie on each other must push as hard as one and a half columns of their material on any mesh:
// vertices of one plate, vertices of the other and edges have half a column each. Edges are as long as 12, 6
// and 3 thicknesses. The mesh may have a small influence, since a vertex over an edge of the other sheet has
// pairs with two triangles.
TEST(SheetContact, PressureIsThatOfTheColumnOnAnyMesh) {
    const double press = 0.001 * test::ceramic.thickness,
                 column = test::ceramic.young * common_area() / test::ceramic.thickness;
    const Barrier barrier{0.25 * test::ceramic.thickness};
    for (const int count : {4, 8, 16}) {
        const Shell shell = test::stacked_plates(2, count, test::ceramic.thickness - press, test::ceramic);
        Positions sum = Positions::Zero(3, shell.position.cols());
        SheetContact(shell).add_gradient(shell.position, sum);
        const double force = sum.row(2).head(sum.cols() / 2).sum();
        EXPECT_NEAR(force / (-column * barrier.slope(barrier.range - press)), 1.5, 0.15) << count;
    }
}

// Coincident vertices must not push each other, while elements beside them still collide.
TEST(SheetContact, ExemptPairsDoNotCollide) {
    Shell shell = test::stacked_plates(2, 2, 1.8e-3, test::ceramic);
    const std::size_t before = SheetContact(shell).active_pairs(shell.position).size();
    shell.exempt_pairs = {{4, 13}};  // the central vertices
    const auto after = SheetContact(shell).active_pairs(shell.position);
    EXPECT_LT(after.size(), before);
    EXPECT_GT(after.size(), 0u);
    for (const ContactPair& pair : after)
        EXPECT_LT(std::count(pair.vertices.begin(), pair.vertices.end(), 4) +
                      std::count(pair.vertices.begin(), pair.vertices.end(), 13),
                  2);
}

TEST(SheetContact, OverlapIsRefusedByName) {
    Shell shell = test::stacked_plates(2, 2, 1e-3, test::ceramic);
    StepperOptions options;
    options.contact.sheets = true;
    ImplicitStepper step(shell, options);
    EXPECT_EQ(step.begin().outcome, Outcome::failed);
    EXPECT_NE(step.begin().why.find("vertices"), std::string::npos);
}

struct Collision {
    double nearest = std::numeric_limits<double>::infinity();
    int intersections = 0, iterations = 0, unconverged = 0;
    double momentum_change = 0, momentum_moved = 0;
};

/// Throws the upper plate, tilted, at the lower one at `speed` (m/s), without gravity, and makes `steps`
/// steps of `step` s.
Collision collide(Shell& shell, double speed, double step, int steps) {
    const Index half = static_cast<Index>(shell.position.cols()) / 2;
    for (Index v = half; v < shell.position.cols(); ++v) {
        shell.velocity.col(v) = Vector3d(0.1 * speed, 0, -speed);
        shell.position(2, v) += 0.2 * shell.position(0, v) + 0.012;
    }
    StepperOptions options;
    options.step = step;
    options.gravity.setZero();
    options.contact.sheets = true;
    options.tolerance = 1e-9;
    ImplicitStepper time_step(shell, options);
    const Vector3d momentum = linear_momentum(shell);
    Collision result;
    for (int i = 0; i < steps; ++i) {
        time_step.begin();
        const StepResult newton = time_step.solve(200);
        time_step.finish();
        result.iterations += newton.iterations;
        result.unconverged += !newton;
        result.nearest = std::min(result.nearest, test::smallest_distance(shell, shell.position));
        result.intersections += test::intersections(shell, shell.position);
    }
    result.momentum_change = (linear_momentum(shell) - momentum).norm() / momentum.norm();
    result.momentum_moved = (shell.velocity.leftCols(half) * shell.mass.head(half)).norm() / momentum.norm();
    return result;
}

// Plates must not intersect at any speed, nor lose momentum.
TEST(SheetContact, CollidingPlatesDoNotPassThroughEachOther) {
    struct Case {
        Material material;
        double speed, step;
    };
    for (const Case& c :
         {Case{test::ceramic, 3, 1e-4}, Case{test::ceramic, 60, 1e-4}, Case{test::rubber, 10, 3e-4}}) {
        Shell shell = test::stacked_plates(2, 5, 0, c.material);
        const Collision result = collide(shell, c.speed, c.step, 60);
        EXPECT_EQ(result.intersections, 0);
        EXPECT_GT(result.nearest, 0.75 * c.material.thickness);
        EXPECT_LT(result.nearest, c.material.thickness);
        EXPECT_LT(result.momentum_change, 1e-8);
        EXPECT_GT(result.momentum_moved, 0.1);
        EXPECT_EQ(result.unconverged, 0);
        EXPECT_LT(result.iterations, 60 * 12);
    }
}

}  // namespace
}  // namespace sherd
