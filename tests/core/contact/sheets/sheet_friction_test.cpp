// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheets/sheet_friction.h"

#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/contact/contact_pairs.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

const Material board{.density = 1000, .thickness = 2e-3, .young = 1e8, .poisson = 0.3};
constexpr double step = 1e-3;

/// Near pairs of both kinds and all cases, of stiffness 1.
std::vector<std::pair<ContactPair, PairPositions>> touching_pairs() {
    std::vector<std::pair<ContactPair, PairPositions>> pairs;
    for (const PairKind kind : {PairKind::vertex_triangle, PairKind::edge_edge})
        for (const PairPositions& x : test::adversarial_pairs(400)) {
            const double apart = std::sqrt(squared_distance(closest_points(kind, x), x));
            if (apart < 1e-3) continue;
            pairs.push_back({{kind, {0, 1, 2, 3}, 1, 1.1 * apart, edge_mollifier(1, 1)}, x});
        }
    return pairs;
}

/// Whether the edges determine every rotation of the pair: those of needles and of parallel edges do not.
bool shows_rotation(const ContactPair& pair, const PairPositions& x) {
    const bool edges = pair.kind == PairKind::edge_edge;
    const Vector3d u = edges ? x.col(1) - x.col(0) : x.col(2) - x.col(1);
    const Vector3d v = edges ? x.col(3) - x.col(2) : x.col(3) - x.col(1);
    return u.cross(v).norm() > 0.03 * u.norm() * v.norm();
}

// A heap that turns or flies as a whole must have no friction: friction would slow it down.
TEST(SheetFriction, RigidMotionDoesNotSlide) {
    test::Random random(2);
    int shown = 0;
    for (const auto& [pair, x] : touching_pairs()) {
        const SlidingPair sliding = sliding_pair(pair, x, 0.5, step);
        if (!shows_rotation(pair, x)) continue;
        ++shown;
        const Vector3d way = random.matrix<Vector3d>(1), turn = random.matrix<Vector3d>(1);
        PairPositions moved;
        for (int i = 0; i < 4; ++i) moved.col(i) = way + turn.cross(Vector3d(x.col(i)));
        EXPECT_LT((sliding.slip * moved.reshaped()).norm(), 1e-4) << x;
    }
    EXPECT_GT(shown, 300);
}

// Newton's third law: with a net force or torque, friction would set a heap in motion.
TEST(SheetFriction, ForcesHaveNeitherSumNorTorque) {
    for (const auto& [pair, x] : touching_pairs()) {
        if (!shows_rotation(pair, x)) continue;
        const SlidingPair sliding = sliding_pair(pair, x, 0.5, step);
        const Eigen::Matrix<double, 12, 1> flat = sliding.slip.transpose() * Vector3d(1, 2, 3);
        Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
        for (int i = 0; i < 4; ++i) {
            const Vector3d force = flat.segment<3>(3 * i);
            sum += force;
            torque += x.col(i).cross(force);
        }
        EXPECT_LT(sum.norm(), 1e-12 * (1 + flat.norm()));
        EXPECT_LT(torque.norm(), 1e-4 * (1 + flat.norm()));
    }
}

// An element that translates over the other slides by its displacement in the plane of sliding, wherever it
// touches.
TEST(SheetFriction, SlidingCountsInFull) {
    test::Random random(3);
    for (const auto& [pair, x] : touching_pairs()) {
        const SlidingPair sliding = sliding_pair(pair, x, 0.5, step);
        const Vector3d way = random.matrix<Vector3d>(1);
        PairPositions moved = PairPositions::Zero();
        moved.leftCols(pair.kind == PairKind::edge_edge ? 2 : 1).colwise() = way;
        EXPECT_LT((sliding.slip * moved.reshaped() - sliding.tangent * way).norm(), 1e-12) << x;
        const Vector3d between = x * closest_points(pair.kind, x).weights;
        EXPECT_LT((sliding.tangent * between).norm(), 1e-12);
    }
}

TEST(SheetFriction, ForceAndStiffnessAreDerivativesOfTheValue) {
    const Shell shell = test::stacked_plates(2, 4, 1.9e-3, board);
    const SheetContact contact(shell);
    SheetFriction friction = test::begun(SheetFriction(shell, contact, 0.5), shell, 0, step);
    test::Random random(5);
    for (const double way : {0.2, 0.2, 5.0}) {  // sticks, sticks with a force from the step before, slips
        Positions x = shell.position;
        for (double& entry : x.reshaped()) entry += random.uniform(-0.3, 0.3) * smoothing_speed * step;
        x.rightCols(x.cols() / 2).row(0).array() += way * smoothing_speed * step;
        test::expect_derivatives(friction, x, 1e-9, 1e-4);
        friction.finish(x);
        friction.begin(test::step_of(shell, 0, step));
    }
}

// A sticking contact must keep its force in the next step, whatever the step's length: otherwise it would
// creep or jump.
TEST(SheetFriction, HoldsFromStepToStep) {
    const Shell shell = test::stacked_plates(2, 4, 1.9e-3, board);
    const SheetContact contact(shell);
    SheetFriction friction = test::begun(SheetFriction(shell, contact, 0.5), shell, 0, step);
    Positions x = shell.position;
    x.rightCols(x.cols() / 2).row(0).array() += 0.3 * smoothing_speed * step;
    const auto force = [&](const Positions& at) {
        Positions gradient = Positions::Zero(3, at.cols());
        friction.add_gradient(at, gradient);
        return gradient;
    };
    const Positions before = force(x);
    ASSERT_GT(before.norm(), 0);
    friction.finish(x);
    for (const double length : {step, 0.1 * step}) {
        friction.begin(test::step_of(shell, 0, length));
        EXPECT_LT((force(shell.position) - before).norm(), 1e-9 * before.norm()) << length;
    }
}

// Coulomb: a plate that slides on a fixed one stops after v^2 / (2 mu g), to 3 %.
TEST(SheetFriction, StopsASlidingPlateAfterTheCoulombDistance) {
    Shell shell = test::stacked_plates(2, 4, 0.99984 * board.thickness, board);
    const Index half = static_cast<Index>(shell.position.cols()) / 2;
    std::fill_n(shell.fixed.begin(), half, 1);
    const double speed = 0.3, coefficient = 0.4;
    shell.velocity.rightCols(half).row(0).setConstant(speed);
    StepperOptions options;
    options.step = 2e-4;
    options.contact.sheets = true;
    options.contact.friction = coefficient;
    ImplicitStepper time_step(shell, options);
    const double start = shell.position.rightCols(half).row(0).mean();
    for (int i = 0; i < 500; ++i) {
        time_step.begin();
        EXPECT_TRUE(time_step.solve(100));
        time_step.finish();
    }
    const double distance = speed * speed / (2 * coefficient * 9.81);
    EXPECT_NEAR(shell.position.rightCols(half).row(0).mean() - start, distance, 0.03 * distance);
    EXPECT_LT(shell.velocity.rightCols(half).norm() / std::sqrt(half), 5e-3);
    EXPECT_EQ(test::intersections(shell, shell.position), 0);
}

}  // namespace
}  // namespace sherd
