// SPDX-License-Identifier: GPL-3.0-or-later
// With errors in advance_edge(), a crack's path would depend on the mesh, or the mesh would deteriorate
// along the path.
#include "meshops/topology/advance/advance_edge.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "meshops/mesh_measures.h"
#include "tests/support/mesh/drawn_sheet.h"
#include "tests/support/mesh/sheet_oracle.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;
using Way = AdvancedEdge::Way;

/// Expects that no angle of the changed faces is below 20 degrees or, if that is less, below the smallest
/// angle of the faces that they replace.
void expect_angles(const TriangleSheet& old, const TriangleSheet& now, const TopologyChange& change) {
    constexpr double round_off = 1e-6;
    double made = 180, replaced = 180;
    for (const auto& [face, shares] : change.reshaped)
        made = std::min(made, smallest_angle_of(corners_of(now, face.idx())));
    for (const Face face : change.changed)
        replaced = std::min(replaced, smallest_angle_of(corners_of(old, face.idx())));
    EXPECT_GE(made, std::min(20.0, replaced) - round_off);
}

/// Path of edges that are inserted and kept; the mesh after each insertion is compared with the reference
/// (sheet_oracle.h).
class Path {
  public:
    Path(Mesh& mesh, Vertex tip, bool is_flat, bool snap) : mesh(mesh), tip(tip), is_flat(is_flat) {
        points.push_back(position(mesh, tip));
        path.insert(tip);
        options.snap = snap;
        options.kept.is_fixed_vertex = [this](Vertex v) { return path.contains(v); };
        options.kept.is_line = [this](Edge e) { return edges.contains(e); };
    }
    Path(const Path&) = delete;

    /// Inserts the next edge. Returns nothing if the path has ended, at the boundary or at itself.
    std::optional<AdvancedEdge> advance(const Vector3d& direction) {
        if (has_ended) return std::nullopt;
        const TriangleSheet old = arrays_of(mesh);
        auto advanced = advance_edge(mesh, tip, direction, options);
        if (!advanced) return std::nullopt;
        ++ways[static_cast<int>(advanced->way)];
        expect_same_sheet(old, mesh, advanced->change, is_flat);
        expect_angles(old, arrays_of(mesh), advanced->change);
        EXPECT_LE(advanced->change.vertices.size(), 2u);
        EXPECT_EQ(mesh.source(advanced->halfedge), tip);
        for (const Vertex v : path) EXPECT_EQ(places.contains(v) ? places[v] : points[0], position(mesh, v));
        tip = mesh.target(advanced->halfedge);
        places[tip] = position(mesh, tip);
        points.push_back(position(mesh, tip));
        edges.insert(mesh.edge(advanced->halfedge));
        has_ended = !path.insert(tip).second || mesh.is_border(tip);
        return advanced;
    }

    double length() const {
        double sum = 0;
        for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
        return sum;
    }

    Mesh& mesh;
    Vertex tip;
    bool is_flat, has_ended = false;
    AdvanceOptions options;
    std::set<Vertex> path;
    std::set<Edge> edges;
    std::map<Vertex, Vector3d> places;
    std::vector<Vector3d> points;
    int ways[4] = {0, 0, 0, 0};
};

Vertex random_inner_vertex(const Mesh& mesh, Random& random) {
    for (int i = 0; i < 1000; ++i)
        if (const Vertex v(random.below(mesh.number_of_vertices())); !mesh.is_border(v)) return v;
    return Vertex(0u);
}

/// Whether the vertex or a neighbour of it is on the boundary.
bool is_near_boundary(const Mesh& mesh, Vertex vertex) {
    const auto around = mesh.vertices_around_target(mesh.halfedge(vertex));
    return mesh.is_border(vertex) || std::ranges::any_of(around, [&](Vertex v) { return mesh.is_border(v); });
}

// An edge may leave the ray only next to the boundary, where the ray meets the boundary at less than 20
// degrees or beside a corner that cannot move, and on poor meshes where the bound on angles allows no other
// edge.
RC_GTEST_PROP(AdvanceEdge, RandomPathsKeepSheetAnglesAndCourse, ()) {
    const unsigned shape = *rc::gen::inRange(0u, sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    Mesh mesh = drawn_sheet(shape, seed);
    Random random(seed + 1);
    Path path(mesh, random_inner_vertex(mesh, random), is_flat_sheet(shape), random.below(4) > 0);
    Vector3d direction = random.matrix<Vector3d>(1);
    if (is_flat_sheet(shape)) direction.z() = 0;
    const Vector3d line = direction.normalized();
    bool is_on_course = true;
    const int steps = is_flat_sheet(shape) ? 40 : 15;  // too few to run round a curved sheet to the start
    for (int i = 0; i < steps; ++i) {
        const auto advanced = path.advance(direction);
        if (!advanced) break;
        direction = advanced->direction;
        EXPECT_TRUE(advanced->off_course < 1e-9 || is_near_boundary(mesh, path.tip) || shape == 4)
            << "shape " << shape << ", seed " << seed << ", step " << i;
        is_on_course = is_on_course && advanced->off_course < 1e-9;
        if (!is_flat_sheet(shape) || !is_on_course) continue;
        const Vector3d way = path.points.back() - path.points.front();
        EXPECT_LE(way.cross(line).norm(), 1e-9) << "step " << i;
        EXPECT_LE(path.length(), (1 + 1e-9) * way.norm());
    }
    RC_ASSERT(!testing::Test::HasFailure());
}

// A crack that turns by up to 20 degrees at every step must still get good triangles.
RC_GTEST_PROP(AdvanceEdge, PathsMayTurn, ()) {
    const unsigned seed = *rc::gen::inRange(0u, 1u << 30);
    Mesh mesh = drawn_sheet(0, seed);
    Random random(seed + 1);
    Path path(mesh, random_inner_vertex(mesh, random), true, true);
    double angle = random.uniform(0, 7);
    for (int i = 0; i < 25; ++i) {
        angle += random.uniform(-0.35, 0.35);
        const Vector3d direction(std::cos(angle), std::sin(angle), 0);
        const auto advanced = path.advance(direction);
        if (!advanced) break;
        const Vector3d way = path.points.back() - path.points[path.points.size() - 2];
        EXPECT_NEAR(way.normalized().dot(direction), std::cos(advanced->off_course), 1e-9);
        EXPECT_TRUE(advanced->off_course < 1e-9 || is_near_boundary(mesh, path.tip) || path.has_ended);
    }
    RC_ASSERT(!testing::Test::HasFailure());
}

// The prescribed curve is a great circle: each direction is its tangent at the tip.
TEST(AdvanceEdge, FollowsACurveOnASphere) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Mesh mesh = generate_sphere(1, {.edge_length = 0.15, .seed = seed});
        Path path(mesh, Vertex(17 * seed), false, true);
        const Vector3d start = path.points[0].normalized(), pole = start.unitOrthogonal();
        double turned = 0;
        for (int i = 0; i < 25; ++i) {
            ASSERT_TRUE(path.advance(pole.cross(position(mesh, path.tip))));
            const Vector3d now = path.points.back().normalized();
            turned = std::atan2(start.cross(now).dot(pole), start.dot(now));
            EXPECT_LT(std::abs(now.dot(pole)), 0.01) << "off the great circle";
            if (turned < 0) break;
        }
        EXPECT_LE(path.length(), 1.02 * (turned < 0 ? turned + 2 * std::numbers::pi : turned));
        EXPECT_EQ(path.ways[0], 0);
    }
}

TEST(AdvanceEdge, EndsAtTheReachAndAtTheBoundary) {
    Mesh mesh = grid(4, 4);
    AdvanceOptions options;
    options.reach = 0.9;
    const auto near = advance_edge(mesh, Vertex(6u), {1, 0.4, 0}, options);
    ASSERT_TRUE(near);
    const Vector3d end = Vector3d(1, 1, 0) + 0.9 * Vector3d(1, 0.4, 0).normalized();
    EXPECT_LT((position(mesh, mesh.target(near->halfedge)) - end).norm(), 1e-12);
    const auto out = advance_edge(mesh, Vertex(16u), {0.2, 1, 0}, {});
    ASSERT_TRUE(out);
    EXPECT_TRUE(mesh.is_border(mesh.target(out->halfedge)));
    EXPECT_EQ(position(mesh, mesh.target(out->halfedge)), Vector3d(1.2, 4, 0));
    EXPECT_FALSE(advance_edge(mesh, mesh.target(out->halfedge), {0, 1, 0}, {})) << "off the sheet";
}

TEST(AdvanceEdge, TakesAnEdgeThatLiesOnTheRay) {
    Mesh mesh = grid(4, 4);
    const Halfedge along = mesh.halfedge(Vertex(6u), Vertex(7u));
    const auto advanced = advance_edge(mesh, Vertex(6u), {1, 0, 0}, {});
    ASSERT_TRUE(advanced);
    EXPECT_EQ(advanced->way, Way::existing);
    EXPECT_EQ(advanced->halfedge, along);
    EXPECT_TRUE(advanced->change.reshaped.empty());
}

// Prints the table of docs/theory/geometry.md.
TEST(AdvanceEdge, PrintsHowPathsAreMade) {
    const char* names[] = {"rectangle", "cylinder", "sphere", "squares"};
    for (const bool snap : {true, false})
        for (int shape = 0; shape < 4; ++shape) {
            int ways[4] = {0, 0, 0, 0};
            double smallest = 180;
            for (unsigned seed = 1; seed <= 10; ++seed) {
                Mesh mesh = shape == 0   ? generate_rectangle(1, 1, {.edge_length = 0.05, .seed = seed})
                            : shape == 1 ? generate_cylinder(0.3, 1, {.edge_length = 0.06, .seed = seed})
                            : shape == 2 ? generate_sphere(0.5, {.edge_length = 0.08, .seed = seed})
                                         : grid(20, 20);
                Random random(seed);
                Path path(mesh, random_inner_vertex(mesh, random), is_flat_sheet(shape), snap);
                Vector3d direction = random.matrix<Vector3d>(1);
                if (is_flat_sheet(shape)) direction.z() = 0;
                for (int i = 0; i < 30; ++i) {
                    const auto advanced = path.advance(direction);
                    if (!advanced) break;
                    direction = advanced->direction;
                    smallest = std::min(smallest, advanced->smallest_angle * 180 / std::numbers::pi);
                }
                for (int way = 0; way < 4; ++way) ways[way] += path.ways[way];
            }
            std::cout << "| " << names[shape] << " | " << (snap ? "yes" : "no");
            for (const int way : {1, 2, 3, 0}) std::cout << " | " << ways[way];
            std::cout << " | " << std::round(10 * smallest) / 10 << " |\n";
        }
}

// Explicit steps are as short as the narrowest triangle needs them: cracks must get the angles that they want
// where the mesh allows it, and no fewer edges on their paths for that.
TEST(AdvanceEdge, ImprovesAnglesUpToTheWantedOne) {
    const double wanted = 28 * std::numbers::pi / 180;
    AdvanceOptions plain, wide;
    wide.snap_angle = wide.wanted_angle = 28;
    struct Count {
        int made = 0, kept = 0;
    };
    Count of_plain, of_wide;
    const Mesh sheet = drawn_sheet(0, 4);
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const Vertex tip(static_cast<unsigned>(i % static_cast<int>(sheet.number_of_vertices())));
        const double angle = random.uniform(0, 2 * std::numbers::pi);
        for (const bool is_wide : {false, true}) {
            Mesh copy = sheet;
            Count& count = is_wide ? of_wide : of_plain;
            const auto edge =
                advance_edge(copy, tip, {std::cos(angle), std::sin(angle), 0}, is_wide ? wide : plain);
            if (!edge || edge->way == Way::existing) continue;
            ++count.made;
            count.kept += edge->smallest_angle >= wanted;
        }
    }
    EXPECT_GT(of_plain.made, 100);
    EXPECT_GE(of_wide.made, of_plain.made) << "no edge must be off its path for better angles";
    EXPECT_LE(of_wide.made - of_wide.kept, (of_plain.made - of_plain.kept) / 2) << "narrow ones";
    EXPECT_GT(of_plain.made, of_plain.kept) << "else there is nothing to improve";
    std::cout << of_plain.made - of_plain.kept << " of " << of_plain.made << " edges leave narrow triangles, "
              << of_wide.made - of_wide.kept << " if these are to be improved\n";
}

}  // namespace
}  // namespace sherd::test
