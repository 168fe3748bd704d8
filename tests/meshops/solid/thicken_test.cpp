// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/solid/thicken.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/solid/body_check.h"

namespace sherd {
namespace {

GenerateOptions edges(double length) {
    GenerateOptions options;
    options.edge_length = length;
    return options;
}

TriangleSheet bowl() {
    std::vector<Eigen::Vector2d> profile;
    for (int i = 0; i <= 30; ++i) {
        const double angle = i * std::numbers::pi / 60;
        profile.emplace_back(0.08 * std::sin(angle), -0.08 * std::cos(angle));
    }
    return triangle_sheet(generate_revolution(profile, edges(0.006)));
}

/// Two squares that meet in a right angle along x = 0.
TriangleSheet fold() {
    TriangleSheet sheet;
    for (int i = -8; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j)
            sheet.points.emplace_back(0.01 * std::min(i, 0), 0.01 * j, 0.01 * std::max(i, 0));
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 8; ++j) {
            const int a = 9 * i + j, b = a + 9;
            sheet.triangles.push_back({a, b, b + 1});
            sheet.triangles.push_back({a, b + 1, a + 1});
        }
    return sheet;
}

double area(const TriangleSheet& sheet) {
    double sum = 0;
    for (const auto& [a, b, c] : sheet.triangles) {
        const Eigen::Vector3d e = sheet.points[b] - sheet.points[a], f = sheet.points[c] - sheet.points[a];
        sum += e.cross(f).norm() / 2;
    }
    return sum;
}

TriangleSheet solid(const TriangleSheet& sheet, double thickness, std::span<const std::int32_t> origin = {}) {
    return thickened(sheet, std::vector<double>(sheet.triangles.size(), thickness), origin);
}

void expect_body(const TriangleSheet& sheet, double thickness, double tolerance) {
    const BodyCheck check = check_body(solid(sheet, thickness));
    EXPECT_TRUE(check.manifold);
    EXPECT_TRUE(check.closed);
    EXPECT_TRUE(check.outward);
    EXPECT_TRUE(check.intersections.empty()) << check.intersections.size();
    const double expected = area(sheet) * thickness;
    EXPECT_NEAR(check.volume, expected, tolerance * expected);
}

// A printer or a boolean operation would refuse an open body, and its weight would be wrong.
TEST(Thicken, PlateAndBowlAreClosedBodiesOfTheirVolume) {
    expect_body(triangle_sheet(generate_disc(0.1, edges(0.008))), 0.004, 1e-9);
    expect_body(bowl(), 0.003, 0.01);
    expect_body(triangle_sheet(generate_cylinder(0.05, 0.1, edges(0.006))), 0.004, 0.01);
}

// A sheet without a boundary becomes a shell around a cavity: two surfaces, and still a body.
TEST(Thicken, ClosedSheetEnclosesACavity) {
    expect_body(triangle_sheet(generate_sphere(0.1, edges(0.01))), 0.003, 0.01);
}

// If points moved along the vertex normals by only half the thickness, a folded sheet would be 30 % thinner
// at the fold.
TEST(Thicken, FoldKeepsItsThickness) {
    expect_body(fold(), 0.002, 0.01);
    const TriangleSheet sheet = fold(), body = solid(sheet, 0.002);
    const std::size_t ridge = 8 * 9 + 4;
    ASSERT_EQ(sheet.points[ridge], Eigen::Vector3d(0, 0.04, 0));
    EXPECT_NEAR((body.points[ridge] - sheet.points[ridge]).norm(), 0.001 * std::numbers::sqrt2, 1e-9);
}

// A fold that is nearly closed would give a spike as long as the sheet.
TEST(Thicken, NeedleOfAFoldIsNoSpike) {
    TriangleSheet sheet;
    sheet.points = {{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0.01}, {1, 0.5, -0.01}};
    sheet.triangles = {{0, 2, 1}, {0, 1, 3}};
    for (const auto& point : solid(sheet, 0.1).points) {
        double nearest = 1;
        for (const auto& original : sheet.points) nearest = std::min(nearest, (point - original).norm());
        EXPECT_LE(nearest, 0.1 + 1e-12);
    }
}

/// First square of the fold with a crack from its rim to its centre along j = 4, whose faces touch. turn:
/// slope of the sheet away from the crack, on both sides.
TriangleSheet cracked(std::vector<std::int32_t>& origin, double turn) {
    TriangleSheet sheet = fold();
    sheet.triangles.resize(8 * 16);
    sheet.points.resize(9 * 9);
    for (int i = 0; i < 81; ++i) origin.push_back(i);
    for (int i = 0; i < 4; ++i) {
        const int old = 9 * i + 4, created = static_cast<int>(sheet.points.size());
        sheet.points.push_back(sheet.points[old]);
        origin.push_back(old);
        // In each column the last four pairs of triangles lie beyond the crack.
        for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
            if (t % 16 >= 8) std::ranges::replace(sheet.triangles[t], old, created);
    }
    for (auto& point : sheet.points) point.z() += turn * std::abs(point.y() - 0.04);
    return sheet;
}

// The faces of a closed crack coincide: a body that is cut open must not intersect itself there.
TEST(Thicken, SidesOfAClosedCrackDoNotMeet) {
    for (const double turn : {0.0, 0.1, -0.1}) {
        std::vector<std::int32_t> origin;
        const TriangleSheet sheet = cracked(origin, turn);
        ASSERT_FALSE(check_body(sheet).intersections.empty()) << "the sheet itself touches itself there";
        const BodyCheck check = check_body(solid(sheet, 0.003, origin));
        EXPECT_TRUE(check.closed && check.outward);
        EXPECT_TRUE(check.intersections.empty()) << check.intersections.size() << " at turn " << turn;
        EXPECT_NEAR(check.volume, area(sheet) * 0.003, 0.01 * area(sheet) * 0.003);
    }
}

// Users identify points and faces by their numbers, which must not change.
TEST(Thicken, KeepsTheOrderOfPointsTrianglesAndGroups) {
    TriangleSheet sheet = fold();
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        sheet.group.push_back(t < 128 ? 0 : 1);
        sheet.quality.push_back(static_cast<double>(t));
    }
    sheet.group_names = {"a", "b"};
    const TriangleSheet body = solid(sheet, 0.002);
    const std::size_t points = sheet.points.size(), triangles = sheet.triangles.size();
    ASSERT_EQ(body.points.size(), 2 * points);
    ASSERT_EQ(body.triangles.size(), 2 * triangles + 2 * (2 * 16 + 2 * 8));
    for (std::size_t i = 0; i < points; ++i)
        EXPECT_LT(((body.points[i] + body.points[points + i]) / 2 - sheet.points[i]).norm(), 1e-15);
    for (std::size_t t = 0; t < triangles; ++t) {
        EXPECT_EQ(body.triangles[t], sheet.triangles[t]);
        EXPECT_EQ(body.quality[triangles + t], sheet.quality[t]);
        EXPECT_EQ(body.group[triangles + t], sheet.group[t]);
    }
    EXPECT_EQ(body.group.size(), body.triangles.size());
}

// If the check found no faults, tests that use it would prove nothing.
TEST(CheckBody, FindsWhatIsWrong) {
    EXPECT_FALSE(check_body(fold()).closed);
    TriangleSheet body = solid(fold(), 0.002);
    for (auto& triangle : body.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_FALSE(check_body(body).outward);
    body.triangles.push_back(body.triangles.front());
    EXPECT_FALSE(check_body(body).manifold);
    EXPECT_FALSE(check_body(solid(fold(), 0.05)).intersections.empty()) << "thicker than it is wide";
}

}  // namespace
}  // namespace sherd
