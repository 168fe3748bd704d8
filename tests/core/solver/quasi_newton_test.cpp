// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/quasi_newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

/// Positions after some steps, and the number of factorizations.
struct Outcome {
    Positions position;
    std::int64_t factorizations = 0;
};

Outcome after(int steps, Shell shell, StepperOptions options, Method method) {
    options.method = method;
    ImplicitStepper stepper(shell, options);
    for (int i = 0; i < steps; ++i) test::advance(stepper);
    return {shell.position, stepper.time_spent().times(Task::factorization)};
}

/// Largest difference of a coordinate, m, between the results of both methods. Fails unless the quasi-Newton
/// method factorizes less often.
double difference(int steps, const Shell& shell, const StepperOptions& options) {
    const Outcome lagged = after(steps, shell, options, Method::quasi_newton);
    const Outcome exact = after(steps, shell, options, Method::newton);
    EXPECT_LT(lagged.factorizations, exact.factorizations);
    return (lagged.position - exact.position).cwiseAbs().maxCoeff();
}

/// Plate that spins fast, about an axis in its plane.
Shell spinning_plate() {
    Shell shell = test::stacked_plates(1, 8, 0, test::rubber);
    for (Index v = 0; v < static_cast<Index>(shell.position.cols()); ++v)
        shell.velocity.col(v) = Vector3d(0, 60, 0).cross(shell.position.col(v));
    return shell;
}

// The method must find the minimum of Newton's method, within the tolerance.
TEST(QuasiNewton, EndsWhereNewtonsMethodEnds) {
    StepperOptions options;
    options.step = 1e-3;
    options.tolerance = 1e-9;
    options.contact.sheets = false;
    EXPECT_LT(difference(20, spinning_plate(), options), 20 * 1e-9);
    Shell falling = test::stacked_plates(1, 8, 0, test::rubber);
    falling.position.row(2).array() += 0.51 * test::rubber.thickness;
    falling.velocity.row(2).setConstant(-1);
    options.contact.obstacles = {test::floor()};
    EXPECT_LT(difference(8, falling, options), 8 * 1e-9);
}

/// Thin sheet that starts in waves, which fold it in a new way in each step.
Shell fluttering_sheet() {
    Shell shell = test::stacked_plates(1, 12, 0, test::thin_rubber);
    for (Index v = 0; v < static_cast<Index>(shell.position.cols()); ++v) {
        const Vector3d x = shell.position.col(v);
        shell.velocity.col(v) = Vector3d(0, 0, 3 * std::sin(40 * x.x()) * std::cos(55 * x.y() + 1));
    }
    return shell;
}

/// Total number of iterations in all steps.
int iterations(int steps, Shell shell, StepperOptions options, Method method) {
    options.method = method;
    ImplicitStepper stepper(shell, options);
    int sum = 0;
    for (int i = 0; i < steps; ++i) {
        EXPECT_TRUE(stepper.begin());
        const StepResult result = stepper.solve(200);
        EXPECT_TRUE(result);
        sum += result.iterations;
        stepper.finish();
    }
    return sum;
}

// Where each step folds a sheet in a new way, an old factor is useless; the method must drop it at once.
TEST(QuasiNewton, DropsFactorsThatLeadNowhere) {
    StepperOptions options;
    options.step = 1e-2;
    options.tolerance = 1e-8;
    options.contact.sheets = false;
    const int newton = iterations(8, fluttering_sheet(), options, Method::newton);
    EXPECT_LT(iterations(8, fluttering_sheet(), options, Method::quasi_newton), 2.5 * newton);
    EXPECT_LT(after(8, fluttering_sheet(), options, Method::quasi_newton).factorizations,
              after(8, fluttering_sheet(), options, Method::newton).factorizations);
}

// A factor that is not rotated with the sheet is useless after a quarter of a turn: each step would need a
// new one.
TEST(QuasiNewton, KeepsAFactorWhileASheetTurns) {
    StepperOptions options;
    options.step = 1e-3;
    options.tolerance = 1e-8;
    options.contact.sheets = false;
    const int steps = 100;  // about a full turn
    EXPECT_LT(after(steps, spinning_plate(), options, Method::quasi_newton).factorizations, steps / 4);
}

// Contacts that appear and vanish are patched: without patches each of them would cost a factorization.
TEST(QuasiNewton, FactorsSeldomWhileContactsComeAndGo) {
    Shell shell = test::stacked_plates(2, 8, 3 * test::rubber.thickness, test::rubber);
    shell.velocity.rightCols(shell.velocity.cols() / 2).row(2).setConstant(-3);
    StepperOptions options;
    options.step = 2e-4;
    options.tolerance = 1e-8;
    EXPECT_LT(difference(40, shell, options), 1e-6);
}

/// Falling triangles of 8 mm, each tilted differently.
Shell falling_shards() {
    constexpr Index count = 8;
    Positions rest(3, 3 * count);
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i < count; ++i) {
        const Eigen::AngleAxisd tilt(0.1 + 0.07 * i, Vector3d(std::cos(i), std::sin(i), 0));
        for (const Index corner : {0, 1, 2}) {
            const double angle = 2.1 * corner + i;
            const Vector3d at = 0.0046 * Vector3d(std::cos(angle), std::sin(angle), 0);
            rest.col(3 * i + corner) = tilt * at + Vector3d(0.02 * i, 0, 0.004 + 0.0005 * i);
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    Shell shell = test::small_sheet(rest, triangles, test::ceramic);
    shell.thickness.setConstant(test::ceramic.thickness);
    shell.young.setConstant(test::ceramic.young);
    shell.footprint = shell.mass / (test::ceramic.thickness * test::ceramic.density);
    shell.velocity.row(2).setConstant(-0.3);
    return shell;
}

// The stiffness of a contact is small beside that of a shard, but it alone holds the shard: a factor without
// it would send the shard metres away.
TEST(QuasiNewton, SeesThatContactStopsASmallShard) {
    StepperOptions options;
    options.step = 1e-3;
    options.tolerance = 1e-9;
    options.contact.sheets = false;
    options.contact.obstacles = {test::floor(3e10, 0.3)};
    const int newton = iterations(40, falling_shards(), options, Method::newton);
    EXPECT_LT(iterations(40, falling_shards(), options, Method::quasi_newton), 2 * newton);
}

/// Springs of `spring` N/m that pull each vertex towards a place 1 m below a floor, z = 0, and a barrier of
/// the floor with the energy -`barrier` ln z, J.
struct PressedOnAFloor : Energy {
    explicit PressedOnAFloor(const Positions& x) : home(x) { home.row(2).setConstant(-1); }
    double value(const Positions& x) const override {
        return spring / 2 * (x - home).squaredNorm() - barrier * x.row(2).array().log().sum();
    }
    void add_gradient(const Positions& x, Positions& gradient) const override {
        gradient += spring * (x - home);
        gradient.row(2).array() -= barrier / x.row(2).array();
    }
    void add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const override {
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            hessian.add(v, v, Vector3d(spring, spring, spring + barrier / (x(2, v) * x(2, v))).asDiagonal());
    }
    double safe_fraction(const Positions& x, const Positions& motion) const override {
        const double share = (-motion.row(2).array() / x.row(2).array()).maxCoeff();
        return share > 0.9 ? 0.9 / share : 1;
    }
    void visit_state(StateVisitor&) override {}
    Positions home;
    double spring = 0.01, barrier = 1e-9;
};

// Where a vertex is nearer to a floor than its force allows, each Newton correction only doubles the
// distance. At a tenth of the tolerance the distance is negligible as a displacement, but the recorded
// contact force would be a hundred times too large.
TEST(QuasiNewton, MeetsForcesWhereContactIsFarTooStiff) {
    const Shell shell = test::two_triangles(test::rubber);
    PressedOnAFloor pressed(shell.position);
    TimeSpent spent;
    Potential potential(shell, {&pressed}, spent);
    potential.begin(test::step_of(shell, 0, 1e-3));
    Positions x = shell.position;
    x.row(2).setConstant(1e-9);
    EXPECT_TRUE(QuasiNewton(1e-8).minimise(potential, 10, x).converged);
    EXPECT_LT(potential.gradient(x).cwiseAbs().maxCoeff(), 1e-3 * pressed.spring);
}

// A shell that nothing supports must end with an error and not in a loop.
TEST(QuasiNewton, SaysThatNothingIsDefinite) {
    Shell shell = test::two_triangles(test::rubber);
    TimeSpent spent;
    Potential potential(shell, {}, spent);
    potential.begin(test::step_of(shell, 0, 1e-3));
    Positions x = shell.position;
    EXPECT_THROW(QuasiNewton().minimise(potential, 10, x), std::runtime_error);
}

}  // namespace
}  // namespace sherd
