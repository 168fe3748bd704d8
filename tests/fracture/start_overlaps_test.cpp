// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/start_overlaps.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core/contact/sheets/sheet_contact.h"
#include "meshops/generate.h"
#include "tests/support/mesh_shapes.h"

namespace sherd {
namespace {

/// A square of side 1 m in two triangles, moved by `shift` after a turn about the x axis.
SheetInput square(double degrees, const Vector3d& shift) {
    SheetInput sheet;
    sheet.mesh = generate_rectangle(1, 1, {1, Layout::structured, 1});
    sheet.material = {2400, 0.01, 1e9, 0.2};
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vector3d::UnitX());
    for (const Vertex v : sheet.mesh.vertices()) {
        const Point& p = sheet.mesh.point(v);
        const Vector3d moved = turn * Vector3d(p.x(), p.y(), p.z()) + shift;
        sheet.mesh.point(v) = Point(moved.x(), moved.y(), moved.z());
    }
    return sheet;
}

TEST(StartOverlaps, NoneWhereSheetsAreAThicknessApart) {
    EXPECT_TRUE(start_overlaps(BreakableShell({square(0, {0, 0, 0}), square(0, {0.1, 0, 0.0101})})).empty());
}

// A sheet through the middle of large triangles, far from all their vertices and edges: distances alone would
// not see it.
TEST(StartOverlaps, FindsFacesThatCrossFarFromTheirVertices) {
    const auto found = start_overlaps(BreakableShell({square(0, {0, 0, 0}), square(90, {0.1, 0.4, -0.5})}));
    ASSERT_FALSE(found.empty());
    for (const StartOverlap& overlap : found) {
        EXPECT_LT(overlap.faces[0], overlap.faces[1]);
        EXPECT_LT(overlap.faces[0], 2) << "of the first square";
        EXPECT_GE(overlap.faces[1], 2) << "of the second square";
    }
    EXPECT_TRUE(found.front().crossing);
}

TEST(StartOverlaps, FindsFacesThatAreTooNearWithTheirDistance) {
    const auto found = start_overlaps(BreakableShell({square(0, {0, 0, 0}), square(0, {0.1, 0.1, 0.004})}));
    ASSERT_FALSE(found.empty());
    for (const StartOverlap& overlap : found) {
        EXPECT_FALSE(overlap.crossing);
        EXPECT_NEAR(overlap.distance, 0.004, 1e-12);
        EXPECT_NEAR(overlap.needed, 0.01, 1e-12);
    }
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LT(found[i - 1].faces, found[i].faces);
}

// Patches of one file that were not joined lie on each other at their seam; that must not keep real meshes
// from being run.
TEST(StartOverlaps, NoneAtASeamThatIsNotJoined) {
    SheetInput both = square(0, {0, 0, 0});
    both.mesh.join(square(0, {1, 0, 0}).mesh);
    const BreakableShell sheet({both});
    EXPECT_TRUE(start_overlaps(sheet).empty());
    EXPECT_EQ(sheet.mechanics().twins.size(), 2u);
    EXPECT_TRUE(sheet.mechanics().lips.empty());
    EXPECT_EQ(SheetContact(sheet.mechanics()).value(sheet.mechanics().position), 0);
}

}  // namespace
}  // namespace sherd
