// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/start_overlaps.h"

#include <gtest/gtest.h>

#include "core/contact/sheets/sheet_contact.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/mesh/tilted_square.h"

namespace sherd {
namespace {

using test::tilted_square;

TEST(StartOverlaps, NoneWhereSheetsAreAThicknessApart) {
    EXPECT_TRUE(
        start_overlaps(BreakableShell({tilted_square(0, {0, 0, 0}), tilted_square(0, {0.1, 0, 0.0101})}))
            .empty());
}

// A sheet through the middle of large triangles, far from all their vertices and edges: distances alone would
// miss it.
TEST(StartOverlaps, FindsFacesThatCrossFarFromTheirVertices) {
    const auto found =
        start_overlaps(BreakableShell({tilted_square(0, {0, 0, 0}), tilted_square(90, {0.1, 0.4, -0.5})}));
    ASSERT_FALSE(found.empty());
    for (const StartOverlap& overlap : found) {
        EXPECT_LT(overlap.faces[0], overlap.faces[1]);
        EXPECT_LT(overlap.faces[0], 2) << "of the first square";
        EXPECT_GE(overlap.faces[1], 2) << "of the second square";
    }
    EXPECT_TRUE(found.front().crossing);
}

TEST(StartOverlaps, FindsFacesThatAreTooNearWithTheirDistance) {
    const auto found =
        start_overlaps(BreakableShell({tilted_square(0, {0, 0, 0}), tilted_square(0, {0.1, 0.1, 0.004})}));
    ASSERT_FALSE(found.empty());
    for (const StartOverlap& overlap : found) {
        EXPECT_FALSE(overlap.crossing);
        EXPECT_NEAR(overlap.distance, 0.004, 1e-12);
        EXPECT_NEAR(overlap.needed, 0.01, 1e-12);
    }
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LT(found[i - 1].faces, found[i].faces);
}

// Patches of one file that were not joined coincide at their seam; that must not keep real meshes from being
// run.
TEST(StartOverlaps, NoneAtASeamThatIsNotJoined) {
    SheetInput both = tilted_square(0, {0, 0, 0});
    both.mesh.join(tilted_square(0, {1, 0, 0}).mesh);
    const BreakableShell sheet({both});
    EXPECT_TRUE(start_overlaps(sheet).empty());
    EXPECT_EQ(sheet.mechanics().exempt_pairs.size(), 2u);
    EXPECT_TRUE(sheet.mechanics().crack_faces.empty());
    EXPECT_EQ(SheetContact(sheet.mechanics()).value(sheet.mechanics().position), 0);
}

}  // namespace
}  // namespace sherd
