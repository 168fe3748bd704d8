// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/intersect/self_intersections.h"
#include "meshops/mesh_measures.h"
#include "meshops/random.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_quality.h"

namespace sherd {
namespace {

Mesh cube() {
    Mesh mesh;
    std::vector<Vertex> v;
    for (int i = 0; i < 8; ++i) v.push_back(mesh.add_vertex(Point(i & 1, i >> 1 & 1, i >> 2 & 1)));
    const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        mesh.add_face(v[q[0]], v[q[1]], v[q[2]]);
        mesh.add_face(v[q[0]], v[q[2]], v[q[3]]);
    }
    return mesh;
}

GenerateOptions structured(double edge_length) {
    return {edge_length, Layout::structured, 1};
}

// A rectangle becomes finer and coarser than the input; its straight borders must still end in its corners.
TEST(Remesh, KeepsAreaAndCornersOfARectangle) {
    for (const double edge_length : {0.03, 0.15}) {
        const Mesh mesh = remesh(generate_rectangle(1, 1, structured(0.07)), {edge_length}).mesh;
        const auto quality = test::mesh_quality(mesh);
        std::cout << edge_length << ": " << mesh.number_of_faces() << " faces, angles "
                  << quality.smallest_angle << ", " << quality.mean_smallest_angle << ", edge "
                  << quality.mean_edge << "\n";
        EXPECT_TRUE(mesh.is_valid(false));
        EXPECT_NEAR(quality.area, 1, 1e-9);
        EXPECT_NEAR(quality.mean_edge / edge_length, 1, 0.15);
        EXPECT_GT(quality.mean_smallest_angle, 42);
        EXPECT_FALSE(mesh.has_garbage());
    }
}

/// Bowl with a double wall, whose two surfaces are 0.3 mm apart.
Mesh double_bowl(double edge_length) {
    std::vector<Eigen::Vector2d> profile;
    for (const auto& [radius, from, to] : {std::array{0.05, 0.0, 1.0}, std::array{0.0497, 1.0, 0.0}})
        for (int i = 0; i <= 40; ++i) {
            const double angle = (from + (to - from) * i / 40) * 1.4;
            profile.emplace_back(radius * std::sin(angle), 0.05 - radius * std::cos(angle));
        }
    profile.front().x() = profile.back().x() = 0;
    return generate_revolution(profile, {edge_length, Layout::delaunay, 1});
}

// Triangles of 12 mm deviate from the bowl by more than the distance of its walls: where they would cross,
// the old faces must stay.
TEST(Remesh, ThinWallsThatWouldCrossStay) {
    const Mesh bowl = double_bowl(0.004);
    ASSERT_TRUE(self_intersections(bowl).empty());
    const Remeshed result = remesh(bowl, {0.012, 30, false});
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_EQ(result.crossings, 0u);
    EXPECT_GT(result.kept, 0u);
    EXPECT_TRUE(result.mesh.is_valid(false));
}

// Flat triangles cost solvers iterations and explicit steps substeps; a sphere and a square require no flat
// triangles.
TEST(Remesh, MakesNoSmallAngles) {
    for (const double edge_length : {0.02, 0.05, 0.12}) {
        const Mesh ball = generate_sphere(0.3, {0.04, Layout::delaunay, 1});
        const Mesh square = generate_rectangle(1, 1, structured(0.1));
        EXPECT_GT(test::mesh_quality(remesh(ball, {edge_length}).mesh).smallest_angle, 20) << edge_length;
        EXPECT_GT(test::mesh_quality(remesh(square, {edge_length}).mesh).smallest_angle, 20) << edge_length;
    }
}

// Cracks prefer the directions of a lattice: a grid must not remain one.
TEST(Remesh, TakesTheOrderFromAGrid) {
    const Mesh in = generate_rectangle(1, 1, structured(0.04));
    EXPECT_GT(test::mesh_quality(in).order, 0.3);
    EXPECT_LT(test::mesh_quality(remesh(in, {0.04}).mesh).order, 0.1);
}

/// Plate of 0.4 m x 0.1 m that is bent by 90 degrees in its middle, with the radius `radius` (m).
Mesh hook(double radius) {
    Mesh mesh = generate_rectangle(0.4, 0.1, structured(0.005));
    const double bent = radius * std::numbers::pi / 2;
    for (const Vertex v : mesh.vertices()) {
        const Point& p = mesh.point(v);
        const double angle = std::clamp((p.x() - 0.2) / radius, 0.0, std::numbers::pi / 2);
        const double beyond = std::max(0.0, p.x() - 0.2 - bent);
        mesh.point(v) = Point(std::min(p.x(), 0.2) + radius * std::sin(angle), p.y(),
                              radius * (1 - std::cos(angle)) + beyond);
    }
    return mesh;
}

// Where a plate is bent on the scale of an edge, long edges would cut the corner.
TEST(Remesh, EdgesAreShorterWhereItIsCurved) {
    const Mesh in = hook(0.02);
    const Remeshed fixed = remesh(in, {0.04, 30, false}), adaptive = remesh(in, {0.04, 30, true});
    EXPECT_LT(adaptive.distance, 0.75 * fixed.distance);
    EXPECT_GT(adaptive.mesh.number_of_faces(), fixed.mesh.number_of_faces());
    EXPECT_LT(adaptive.mesh.number_of_faces(), in.number_of_faces() / 4) << "the flat has long edges";
    EXPECT_GT(test::mesh_quality(adaptive.mesh).smallest_angle, 20);
}

// The noise of scanners bends edges, but must not count as creases that are kept.
TEST(Remesh, NoiseIsNoFeature) {
    Mesh ball = generate_sphere(0.1, {0.004, Layout::delaunay, 1});
    Random random(1);
    for (const Vertex v : ball.vertices()) {
        const double swell = 1 + 0.016 * (random.uniform() - 0.5);
        const Point& p = ball.point(v);
        ball.point(v) = Point(swell * p.x(), swell * p.y(), swell * p.z());
    }
    const Mesh result = remesh(ball, {0.016}).mesh;
    EXPECT_LT(result.number_of_faces(), ball.number_of_faces() / 6);
    EXPECT_GT(test::mesh_quality(result).smallest_angle, 20);
}

// Between creases the surface is flat: a vertex that slips over a sharp crease folds the triangles there.
TEST(Remesh, VerticesStayOnTheirSideOfCreases) {
    Mesh blade;  // flat pyramid of three sides
    const Vertex a = blade.add_vertex(Point(0, 0, 0)), b = blade.add_vertex(Point(1, 0, 0)),
                 c = blade.add_vertex(Point(0.4, 0.9, 0)), top = blade.add_vertex(Point(0.5, 0.3, 0.06));
    blade.add_face(a, c, b);
    blade.add_face(a, b, top);
    blade.add_face(b, c, top);
    blade.add_face(c, a, top);
    for (const double edge_length : {0.2, 0.08, 0.03}) {
        const Remeshed result = remesh(blade, {edge_length, 5, false});
        EXPECT_LT(result.distance, 1e-9) << edge_length;
        EXPECT_EQ(result.kept, 0u);
        EXPECT_TRUE(self_intersections(result.mesh).empty());
    }
}

// The hole of a thin handle must remain.
TEST(Remesh, KeepsHandles) {
    const auto euler = [](const Mesh& mesh) {
        return int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
    };
    std::vector<Eigen::Vector2d> profile;
    for (int i = 0; i <= 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        profile.emplace_back(0.05 + 0.002 * std::cos(angle), 0.002 * std::sin(angle));
    }
    const Mesh ring = generate_revolution(profile, {0.002, Layout::delaunay, 1});
    const Remeshed result = remesh(ring, {0.02});
    EXPECT_EQ(euler(result.mesh), euler(ring));
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_LT(result.mesh.number_of_faces(), ring.number_of_faces());
}

// The result must tell its distance from the input: triangles with corners on a sphere lie inside it by
// their rise.
TEST(Remesh, TellsItsDistance) {
    const double radius = 0.1, edge = 0.03;
    const Remeshed coarse = remesh(generate_sphere(radius, {0.005, Layout::delaunay, 1}), {edge});
    const double rise = edge * edge / (6 * radius);  // at the centre of an equilateral triangle
    EXPECT_GT(coarse.distance, 0.7 * rise);
    EXPECT_LT(coarse.distance, 3 * rise);
    EXPECT_EQ(coarse.kept, 0u) << "nothing crosses";
    EXPECT_LT(remesh(cube(), {0.1}).distance, 1e-9) << "a box of planes keeps its shape";
}

// Intersections in the input come from the file: remeshing must neither stop at them nor keep all the faces
// there.
TEST(Remesh, WhatCrossesBeforeMayCrossAfter) {
    Mesh two = cube();
    Mesh other = cube();
    for (const Vertex v : other.vertices()) {
        const Point& p = other.point(v);
        other.point(v) = Point(p.x() + 0.5, p.y() + 0.37, p.z() + 0.41);
    }
    two += other;
    const Remeshed result = remesh(two, {0.1});
    EXPECT_FALSE(self_intersections(result.mesh).empty());
    EXPECT_EQ(result.kept, 0u);
    EXPECT_EQ(result.crossings, 0u);
}

// Without this rule a scan that intersects itself in three places would come out with forty intersections,
// and with edges a hundredth of the requested length, for which explicit steps take thousands of substeps.
TEST(Remesh, CrossesNoMoreOftenThanBefore) {
    const double edge = 0.02;
    Mesh two = generate_sphere(0.1, {edge, Layout::delaunay, 1});
    Mesh other = generate_sphere(0.1, {edge, Layout::delaunay, 2});
    for (const Vertex v : other.vertices())
        other.point(v) = point_at(position(other, v) + Eigen::Vector3d(0.195, 0.01, 0));
    two += other;
    const std::size_t before = self_intersections(two).size();
    ASSERT_GT(before, 0u);
    for (const double asked : {edge, 1.3 * edge, 2 * edge}) {
        const Remeshed result = remesh(two, {asked});
        EXPECT_LE(self_intersections(result.mesh).size(), before) << asked;
        EXPECT_EQ(result.crossings, 0u) << asked;
        EXPECT_GT(measure(result.mesh).smallest_edge, asked / 10) << asked;
    }
}

// Sheets that touch along a seam do not intersect: keeping their faces would leave a strip unmeshed.
TEST(Remesh, RemeshesAlongOpenSeams) {
    Mesh two = generate_rectangle(0.1, 0.1, structured(0.02));
    Mesh other = two;
    for (const Vertex v : other.vertices())
        other.point(v) = point_at(position(other, v) + Eigen::Vector3d(0.1, 0, 0));
    two += other;
    for (const double asked : {0.01, 0.03}) EXPECT_EQ(remesh(two, {asked}).kept, 0u) << asked;
}

// A remeshed box must keep its sharp edges.
TEST(Remesh, KeepsSharpEdges) {
    const Mesh mesh = remesh(cube(), {0.1}).mesh;
    EXPECT_NEAR(test::mesh_quality(mesh).area, 6, 1e-9);
    EXPECT_GT(mesh.number_of_faces(), 800U);
    for (const Vertex v : mesh.vertices()) {
        const Point& p = mesh.point(v);
        const double out = std::max({std::abs(p.x() - 0.5), std::abs(p.y() - 0.5), std::abs(p.z() - 0.5)});
        EXPECT_NEAR(out, 0.5, 1e-9);
    }
}

TEST(Remesh, KeepsComponentsAndStaysOnTheSurface) {
    Mesh mesh = generate_sphere(0.5, {0.05, Layout::delaunay, 1});
    mesh += generate_disc(0.3, {0.05, Layout::delaunay, 1});
    const Mesh result = remesh(mesh, {0.1}).mesh;
    EXPECT_EQ(connected_components(result).count, 2);
    for (const Vertex v : result.vertices()) {
        const Point& p = result.point(v);
        const double from_sphere = std::abs(std::hypot(p.x(), p.y(), p.z()) - 0.5);
        // The original triangles lie up to 1.1e-3 below the sphere.
        EXPECT_LT(std::min(from_sphere, std::abs(p.z())), 1.5e-3);
    }
}

TEST(Remesh, GivesTheSameMeshAgain) {
    const Mesh in = generate_sphere(0.5, {0.05, Layout::delaunay, 1});
    const Mesh first = remesh(in, {0.07}).mesh, again = remesh(in, {0.07}).mesh;
    ASSERT_EQ(first.number_of_faces(), again.number_of_faces());
    for (const Vertex v : first.vertices()) ASSERT_EQ(first.point(v), again.point(v));
    for (const Halfedge h : first.halfedges()) ASSERT_EQ(first.target(h), again.target(h));
}

TEST(Remesh, RefusesAnEdgeLengthThatIsNotPositive) {
    EXPECT_THROW(remesh(cube(), {0}), Error);
    EXPECT_THROW(remesh(cube(), {-1}), Error);
    EXPECT_THROW(remesh(cube(), {std::nan("")}), Error);
}

TEST(Components, AreNumberedByTheirFirstFace) {
    Mesh mesh = cube();
    mesh += cube();
    const auto components = connected_components(mesh);
    EXPECT_EQ(components.count, 2);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(components.of_face[i], i < 12 ? 0 : 1);
    EXPECT_EQ(connected_components(Mesh()).count, 0);
}

// Faces that share only a point are two sheets: nothing bends across a point.
TEST(Components, DoNotReachAcrossAPoint) {
    Mesh mesh;
    std::vector<Vertex> v;
    for (int i = 0; i < 5; ++i) v.push_back(mesh.add_vertex(Point(i, i * i, 0)));
    mesh.add_face(v[0], v[1], v[2]);
    mesh.add_face(v[2], v[3], v[4]);
    EXPECT_EQ(connected_components(mesh).count, 2);
}

}  // namespace
}  // namespace sherd
