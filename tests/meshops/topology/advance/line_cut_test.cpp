// SPDX-License-Identifier: GPL-3.0-or-later
// With errors in LineCut, a line would be cut elsewhere than drawn, or the mesh would not be valid
// afterwards.
#include "meshops/topology/advance/line_cut.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <iostream>
#include <numbers>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "tests/support/mesh/drawn_sheet.h"
#include "tests/support/mesh/sheet_oracle.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

// Prints smallest angles that docs/theory/geometry.md has.
TEST(LineCut, PrintsTheSmallestAnglesOfStraightCuts) {
    std::vector<double> angles;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.06, .seed = seed});
        const TriangleSheet old = arrays_of(mesh);
        Random random(seed);
        const std::vector<LinePoint> line{{{random.uniform(0.05, 0.95), 0, 0}, "start"},
                                          {{random.uniform(0.05, 0.95), 1, 0}, "end"}};
        LineCut cut(mesh, false);
        cut.cut(line);
        const TriangleSheet now = arrays_of(mesh);
        expect_manifold(old, mesh, now);
        EXPECT_NEAR(cut.length(), (line[1].place - line[0].place).norm(), 1e-9);
        angles.push_back(cut.smallest_angle() * 180 / std::numbers::pi);
    }
    std::ranges::sort(angles);
    std::cout << "smallest angles, degrees: least " << angles[0] << ", next " << angles[1] << ", "
              << angles[2] << ", " << angles[5] << ", median " << angles[50] << "\n";
}

RC_GTEST_PROP(LineCut, RandomLinesLeaveTheSheetAMesh, ()) {
    const unsigned shape = *rc::gen::inRange(0u, sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    Mesh mesh = drawn_sheet(shape, seed);
    const TriangleSheet old = arrays_of(mesh);
    Random random(seed + 1);
    LineCut cut(mesh, random.below(3) == 0);
    for (unsigned lines = random.below(2) + 1; lines > 0; --lines) {
        std::vector<LinePoint> line;
        for (unsigned i = random.below(3) + 2; i > 0; --i)
            line.push_back({centroid(mesh, Face(random.below(old.triangles.size()))), "point"});
        try {
            cut.cut(line);
        } catch (const Error& error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.starts_with("point: the line") ||
                        what == "point: a line needs two different points")
                << what;
        }
    }
    const TriangleSheet now = arrays_of(mesh);
    expect_manifold(old, mesh, now);
    for (const Edge edge : cut.edges()) EXPECT_FALSE(mesh.is_border(edge));
    if (is_flat_sheet(shape)) {
        double before = 0, after = 0;
        for (std::size_t f = 0; f < old.triangles.size(); ++f) before += area_of(corners_of(old, f));
        for (std::size_t f = 0; f < now.triangles.size(); ++f) after += area_of(corners_of(now, f));
        EXPECT_NEAR(after, before, 1e-9 * before);
    }
    RC_ASSERT(!testing::Test::HasFailure());
}

}  // namespace
}  // namespace sherd::test
