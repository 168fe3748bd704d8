// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/pieces.h"

#include <gtest/gtest.h>

#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

// With wrong pieces, momentum would be shared by pieces that do not touch.
TEST(Pieces, AreWhatFacesAndLinksConnect) {
    const Shell shell = test::stacked_plates(3, 2, 0.1, test::ceramic);
    const auto each = static_cast<Index>(shell.mass.size()) / 3;
    const Pieces all = pieces(shell);
    EXPECT_EQ(all.count, 3);
    for (Index v = 0; v < 3 * each; ++v) EXPECT_EQ(all.of_vertex[v], v / each);
    const Pieces linked = pieces(shell, {{2 * each + 1, 3}});
    EXPECT_EQ(linked.count, 2);
    EXPECT_EQ(linked.of_vertex[0], linked.of_vertex[2 * each]);
    EXPECT_NE(linked.of_vertex[0], linked.of_vertex[each]);
}

TEST(Pieces, AVertexWithoutFacesIsOne) {
    Shell shell = test::two_triangles(test::rubber);
    resize_vertices(shell, 5);
    EXPECT_EQ(pieces(shell).count, 2);
}

}  // namespace
}  // namespace sherd
