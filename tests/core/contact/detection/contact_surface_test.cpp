// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness of pairs of elements. A vertex of a narrow face, hit with the stiffness of a whole neighbour,
// would set the length of all explicit substeps.
#include "core/contact/detection/contact_surface.h"

#include <gtest/gtest.h>

#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

double stiffness_of(const Shell& shell, bool springs) {
    const ContactSurface surface(shell, {}, true, springs);
    ContactPair pair = surface.bare_pair(PairKind::vertex_triangle, {60, 12, 13, 19}, test::glass.thickness);
    surface.stiffen(pair);
    return pair.stiffness;
}

TEST(ContactSurface, SpringsAreSofterWhereAVertexIsMuchLighter) {
    Shell shell = test::stacked_plates(2, 6, 0.01, test::glass);
    const double even = stiffness_of(shell, true), barrier = stiffness_of(shell, false);
    EXPECT_EQ(even, barrier) << "in an even mesh";
    const double mass = (shell.mass[60] + shell.mass[12] + shell.mass[19]) / 3;
    shell.mass[13] = mass / 100;
    EXPECT_EQ(stiffness_of(shell, false), barrier);
    EXPECT_NEAR(stiffness_of(shell, true), 0.03 * 4 / 3.01 * even, 1e-9 * even);
    shell.mass[13] = 0.5 * mass;
    EXPECT_EQ(stiffness_of(shell, true), even);
}

}  // namespace
}  // namespace sherd
