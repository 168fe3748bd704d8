// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/cracks_about.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "app/measures/cracks/disjoint_paths.h"
#include "tests/support/recording/broken_grid.h"

namespace sherd::test {
namespace {

constexpr Index rings = 8, sectors = 32;

CracksAbout about_middle(const Snapshot& frame, const std::vector<double>& radii = {}) {
    return cracks_about(crack_graph(frame), frame, Vector3d::Zero(), radii);
}

void crack_arm(Snapshot& frame, Index sector) {
    std::vector<Index> path{0};
    for (Index ring = 1; ring <= rings; ++ring) path.push_back(polar_vertex(sectors, ring, sector));
    crack(frame, path);
}

void crack_ring(Snapshot& frame, Index ring, Index first = 0, Index count = sectors) {
    std::vector<Index> path;
    for (Index s = 0; s <= count; ++s) path.push_back(polar_vertex(sectors, ring, first + s));
    crack(frame, path);
}

TEST(CracksAbout, AreRadialOrRings) {
    Snapshot frame = polar_sheet(rings, sectors);
    EXPECT_EQ(about_middle(frame).radial(), 0);
    for (const Index sector : {0, 3, 9, 16, 23}) crack_arm(frame, sector);
    const CracksAbout arms = about_middle(frame);
    ASSERT_EQ(arms.circles.size(), 7u);
    for (const auto& [radius, cracks] : arms.circles) EXPECT_EQ(cracks, 5u) << radius;
    EXPECT_NEAR(arms.circles[6].radius, 7, 1e-12);
    ASSERT_EQ(arms.rays.size(), 16u);
    for (const auto& [angle, cracks] : arms.rays) EXPECT_EQ(cracks, 0u) << angle;
    crack_ring(frame, 3), crack_ring(frame, 6);
    const CracksAbout both = about_middle(frame);
    for (const auto& [radius, cracks] : both.circles) EXPECT_EQ(cracks, 5u) << radius;
    for (const auto& [angle, cracks] : both.rays) EXPECT_EQ(cracks, 2u) << angle;
    EXPECT_EQ(both.radial(), 5);
    EXPECT_EQ(both.ring(), 2);
}

// A ring that zigzags over a circle must not count as a radial crack for each tooth.
TEST(CracksAbout, CountAZigzagOnce) {
    Snapshot frame = polar_sheet(rings, sectors);
    for (Index s = 0; s < sectors; s += 2) frame.rest.position.col(polar_vertex(sectors, 5, s)) *= 1.08;
    crack_ring(frame, 5);
    std::vector<Index> arm{0};
    for (Index ring = 1; ring <= rings; ++ring)  // the crack steps aside on each ring
        for (const Index s : {ring % 2, 1 - ring % 2}) arm.push_back(polar_vertex(sectors, ring, s));
    crack(frame, arm);
    const CracksAbout about = about_middle(frame, {5.2, 2.5});
    ASSERT_EQ(about.circles.size(), 2u);
    EXPECT_EQ(about.circles[0].radius, 2.5);
    EXPECT_EQ(about.circles[0].cracks, 1u);
    EXPECT_EQ(about.circles[1].cracks, 1u);
    EXPECT_EQ(about.ring(), 1);
}

// Half a ring must count on half of the rays, and cracks within the smallest circle on none.
TEST(CracksAbout, CountRingsWhereTheyAre) {
    Snapshot frame = polar_sheet(rings, sectors);
    crack_ring(frame, 4, 0, 16);
    const CracksAbout about = about_middle(frame);
    EXPECT_EQ(std::ranges::count(about.rays, 1u, &CracksAbout::Ray::cracks), 7);
    EXPECT_EQ(about.ring(), 0);
    for (const auto& [angle, cracks] : about_middle(frame, {4.5}).rays) EXPECT_EQ(cracks, 0u) << angle;
}

// About a corner three quarters of the rays leave the plate, and must not be among the rays that rings have
// to cross.
TEST(CracksAbout, HaveRaysWhereThereIsASheet) {
    Snapshot frame = grid_sheet(8, 8);
    std::vector<Index> square;
    for (Index i = 0; i <= 4; ++i) square.push_back(grid_vertex(8, 4, i));
    for (Index i = 3; i >= 0; --i) square.push_back(grid_vertex(8, i, 4));
    crack(frame, square);
    const CracksAbout corner = cracks_about(crack_graph(frame), frame, Vector3d::Zero());
    EXPECT_EQ(corner.rays.size(), 5u);
    EXPECT_EQ(corner.ring(), 1);
}

// A crack in another sheet must not count about a point of this sheet.
TEST(CracksAbout, AreThoseOfTheSheetOfThePoint) {
    Snapshot frame = polar_sheet(rings, sectors);
    crack_arm(frame, 5);
    for (std::size_t f = 0; f < frame.faces.size(); ++f) frame.face_sheet[f] = f < frame.faces.size() / 2;
    EXPECT_EQ(about_middle(frame, {2}).radial(), 1);
    crack_arm(frame, 25);
    EXPECT_EQ(about_middle(frame, {2}).radial(), 1);
}

TEST(DisjointPaths, ShareNoEdgeButVertices) {
    using enum PathRole;
    // Paths begin at the vertices 0 and 1, and end at 5 and 6. With the first four edges all of them pass the
    // edge from 2 to 3.
    std::vector<std::array<Index, 2>> edges{{0, 2}, {2, 1}, {2, 3}, {3, 5}};
    const std::vector<PathRole> roles{begin, begin, between, between, between, end, end, none};
    EXPECT_EQ(disjoint_paths(edges, roles), 1u);
    edges.push_back({4, 2}), edges.push_back({4, 6});
    EXPECT_EQ(disjoint_paths(edges, roles), 2u);
    edges.push_back({0, 7}), edges.push_back({7, 6});
    EXPECT_EQ(disjoint_paths(edges, roles), 2u);  // no path may visit vertex 7
    edges.push_back({1, 5});
    EXPECT_EQ(disjoint_paths(edges, roles), 3u);  // a direct path
}

// The shortest path takes the middle edge, from 1 to 2; two longer paths exist without it.
TEST(DisjointPaths, MakeWayForEachOther) {
    const std::vector<std::array<Index, 2>> edges{{0, 1}, {1, 2}, {2, 7}, {0, 3}, {3, 4},
                                                  {4, 2}, {1, 5}, {5, 6}, {6, 7}};
    std::vector<PathRole> roles(8, PathRole::between);
    roles[0] = PathRole::begin, roles[7] = PathRole::end;
    EXPECT_EQ(disjoint_paths(edges, roles), 2u);
}

// Menger's theorem: the number of paths without a common edge is the least number of edges that separate
// beginning and end. The test tries all subsets of a few edges.
RC_GTEST_PROP(DisjointPaths, AreAsManyAsTheLeastEdgesThatPartTheEnds, ()) {
    const auto vertex = rc::gen::inRange<Index>(0, 6);
    const auto edges =
        *rc::gen::container<std::vector<std::pair<Index, Index>>>(11, rc::gen::pair(vertex, vertex));
    std::vector<std::array<Index, 2>> given;
    for (const auto& [a, b] : edges)
        if (a != b) given.push_back({a, b});
    const std::vector<PathRole> roles{PathRole::begin,   PathRole::begin,   PathRole::between,
                                      PathRole::between, PathRole::between, PathRole::end};
    const auto parts = [&](unsigned removed) {
        std::array<bool, 6> reached{true, true};
        for (int round = 0; round < 6; ++round)
            for (std::size_t e = 0; e < given.size(); ++e)
                if ((removed >> e & 1) == 0 && (reached[given[e][0]] || reached[given[e][1]]))
                    reached[given[e][0]] = reached[given[e][1]] = true;
        return !reached[5];
    };
    int least = 100;
    for (unsigned removed = 0; removed < 1u << given.size(); ++removed)
        if (parts(removed)) least = std::min(least, std::popcount(removed));
    RC_ASSERT(disjoint_paths(given, roles) == static_cast<std::size_t>(least));
}

}  // namespace
}  // namespace sherd::test
