// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/lagged_system.h"

#include <gtest/gtest.h>

#include "core/contact/sheets/sheet_contact.h"
#include "core/time/inertia.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

/// Two plates above each other, and positions where the middle of the upper one touches the lower one.
struct ContactInTheMiddle {
    Shell shell = test::stacked_plates(2, 10, 3 * test::rubber.thickness, test::rubber);
    Inertia inertia{shell, Vector3d::Zero()};
    SheetContact contact{shell};
    TimeSpent spent;
    Potential potential{shell, {&inertia, &contact}, spent};
    Positions apart = shell.position, touching = shell.position;
    Index middle = 3 * static_cast<Index>(shell.position.cols()) / 4;

    /// step: s; in a short step, inertia keeps the Hessian positive definite.
    explicit ContactInTheMiddle(double step) {
        potential.begin(test::step_of(shell, 0, step));
        touching(2, middle) -= 2.1 * test::rubber.thickness;
    }
    BlockMatrix hessian(const Positions& x) const {
        BlockMatrix matrix = potential.hessian_pattern(x);
        potential.hessian(x, Curvature::exact, matrix);
        return matrix;
    }
};

// With a patch that fits only one of the two positions, iterations would lead to the other one and back
// without end.
TEST(LaggedSystem, FitsBothPlacesOfAContactThatComesAndGoes) {
    const ContactInTheMiddle at(1e-3);
    ASSERT_GT(at.contact.active_pairs(at.touching).size(), 0u);
    ASSERT_EQ(at.contact.active_pairs(at.apart).size(), 0u);
    LaggedSystem system;
    system.factorize(at.potential, at.apart);
    int changes = 0;
    for (int round = 0; round < 4; ++round)
        for (const Positions* x : {&at.touching, &at.apart})
            changes += system.fit(at.potential, *x) == LaggedSystem::Fit::patched;
    EXPECT_GT(changes, 2);  // not after one change: a contact that changes once gets a patch of its own
    EXPECT_LT(changes, 8);
    for (const Positions* x : {&at.touching, &at.apart, &at.touching, &at.apart})
        EXPECT_EQ(system.fit(at.potential, *x), LaggedSystem::Fit::fits);
}

TEST(HessianPatch, HasTheMeanOfTwoPlaces) {
    const ContactInTheMiddle at(1e-5);
    ASSERT_GT(at.contact.active_pairs(at.touching).size(), 0u);
    const auto count = static_cast<Index>(at.shell.position.cols());
    const VertexGraph graph(count, at.potential.pattern());
    std::vector<char> inside(count, 0);
    Positions motion = Positions::Zero(3, count);
    for (Index v = 0; v < count; ++v)
        if ((at.shell.position.col(v) - at.shell.position.col(at.middle)).head<2>().norm() < 0.03) {
            inside[v] = 1;
            motion.col(v) = Vector3d(1, 2 + v, -3);
        }
    HessianPatch patch;
    ASSERT_TRUE(patch.build(at.potential, graph, at.touching, &at.apart, inside, Threads()));
    const Positions mean = 0.5 * (at.hessian(at.touching).times(motion) + at.hessian(at.apart).times(motion));
    EXPECT_LT(patch.residual(mean, motion).norm(), 1e-12 * mean.norm());
    const Positions found = patch.solve(mean);
    EXPECT_LT((found - motion).norm(), 1e-4 * motion.norm());  // single precision
}

}  // namespace
}  // namespace sherd
