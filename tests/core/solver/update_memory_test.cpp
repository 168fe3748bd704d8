// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/update_memory.h"

#include <gtest/gtest.h>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using Three = Eigen::Matrix<double, 3, 3>;

/// Product with a positive definite Hessian of three vertices, which is diagonal.
Positions hessian_times(const Positions& step) {
    Positions factors(3, 3);
    factors << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    return factors.cwiseProduct(step);
}

// Secant equation: the inverse Hessian must return the step that made the last change.
TEST(UpdateMemory, GivesBackTheLastStep) {
    test::Random random(1);
    UpdateMemory memory(3);
    const auto solve = [](const Positions& gradient) { return gradient; };
    Positions step, change;
    for (int i = 0; i < 5; ++i) {
        step = random.matrix<Three>(1);
        change = hessian_times(step);
        memory.add(step, change);
        EXPECT_LT((memory.apply(change, solve) - step).norm(), 1e-12 * step.norm());
    }
    memory.clear();
    EXPECT_EQ(memory.apply(change, solve), change);
}

// Where the potential is not convex, the direction must still be a descent direction.
TEST(UpdateMemory, LeavesOutWhatShowsNoConvexity) {
    test::Random random(2);
    UpdateMemory memory(3);
    for (int i = 0; i < 20; ++i) memory.add(random.matrix<Three>(1), random.matrix<Three>(1));
    for (int i = 0; i < 20; ++i) {
        const Positions gradient = random.matrix<Three>(1);
        const Positions direction = memory.apply(gradient, [](const Positions& one) { return one; });
        EXPECT_GT(direction.cwiseProduct(gradient).sum(), 0);
    }
}

}  // namespace
}  // namespace sherd
