// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/generate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <functional>
#include <iostream>

#include "meshops/error.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_quality.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;

std::vector<Vector2d> plate_profile() {
    return {{0, 0}, {0.5, 0}, {0.6, 0.1}, {1, 0.15}};
}

std::vector<Vector2d> bowl_profile() {
    std::vector<Vector2d> profile;
    for (int i = 0; i <= 100; ++i) profile.emplace_back(std::sin(0.015 * i), 1 - std::cos(0.015 * i));
    return profile;
}

struct Shape {
    const char* name;
    std::function<Mesh(const GenerateOptions&)> generate;
    double area;
    int characteristic;
    /// Distance of a point from the surface, m.
    std::function<double(const Vector3d&)> gap;
};

double gap_from_profile(const std::vector<Vector2d>& profile, const Vector3d& p) {
    const Vector2d place(std::hypot(p.x(), p.y()), p.z());
    double least = 1e300;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const Vector2d side = profile[i] - profile[i - 1];
        const double part = std::clamp((place - profile[i - 1]).dot(side) / side.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (profile[i - 1] + part * side - place).norm());
    }
    return least;
}

double area_of_revolution(const std::vector<Vector2d>& profile) {
    double area = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        area += pi * (profile[i].x() + profile[i - 1].x()) * (profile[i] - profile[i - 1]).norm();
    }
    return area;
}

Shape revolution(const char* name, const std::vector<Vector2d>& profile, int characteristic) {
    return {name, [profile](const auto& o) { return generate_revolution(profile, o); },
            area_of_revolution(profile), characteristic,
            [profile](const Vector3d& p) { return gap_from_profile(profile, p); }};
}

/// Sector between the x axis and the angle `angle` (degrees); its gap is the distance from the whole surface
/// of revolution.
Shape sector(const char* name, const std::vector<Vector2d>& profile, double angle) {
    return {name, [profile, angle](const auto& o) { return generate_revolution(profile, o, angle); },
            area_of_revolution(profile) * angle / 360, 1,
            [profile](const Vector3d& p) { return gap_from_profile(profile, p); }};
}

std::vector<Shape> shapes() {
    const auto height = [](const Vector3d& p) { return std::abs(p.z()); };
    const auto from_tube = [](const Vector3d& p) { return std::abs(std::hypot(p.x(), p.y()) - 0.5); };
    const auto from_sphere = [](const Vector3d& p) { return std::abs(p.norm() - 0.5); };
    return {
        {"rectangle", [](const auto& o) { return generate_rectangle(1, 1, o); }, 1, 1, height},
        {"disc", [](const auto& o) { return generate_disc(0.5, o); }, pi / 4, 1, height},
        {"cylinder", [](const auto& o) { return generate_cylinder(0.5, 1, o); }, pi, 0, from_tube},
        {"sphere", [](const auto& o) { return generate_sphere(0.5, o); }, pi, 2, from_sphere},
        revolution("plate", plate_profile(), 1),
        revolution("bowl", bowl_profile(), 1),
        revolution("vase", {{0, 0}, {0.3, 0}, {0.5, 0.5}, {0.3, 1}, {0.25, 1.3}, {0.4, 1.5}}, 1),
        revolution("can", {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, 2),
        revolution("ring", {{0.3, 0}, {0.6, 0}}, 0),
        sector("panel", {{1, 0.8}, {1, 0}}, 40),
        sector("slit_ring", {{0.3, 0}, {0.9, 0}}, 359.9),
        sector("half_vase", {{0.3, 0}, {0.5, 0.5}, {0.3, 1}, {0.4, 1.5}}, 180),
    };
}

GenerateOptions options(double edge_length, unsigned seed = 1) {
    return {edge_length, Layout::delaunay, seed};
}

Vector3d vector(const Point& p) {
    return {p.x(), p.y(), p.z()};
}

class EveryShape : public ::testing::TestWithParam<std::size_t> {
  protected:
    Shape shape = shapes()[GetParam()];
};

// A generated surface must not be torn or folded, nor closed where it should be open.
TEST_P(EveryShape, IsAManifoldOfTheRightTopologyAndArea) {
    for (const double edge_length : {0.02, 0.05, 0.1}) {
        const Mesh mesh = shape.generate(options(edge_length));
        EXPECT_TRUE(mesh.is_valid(false));
        const int characteristic = static_cast<int>(mesh.number_of_vertices()) -
                                   static_cast<int>(mesh.number_of_edges()) +
                                   static_cast<int>(mesh.number_of_faces());
        EXPECT_EQ(characteristic, shape.characteristic);
        EXPECT_EQ(connected_components(mesh).count, 1);
        // Flat triangles cut off a share of about (edge / radius)^2 of a round surface's area.
        const double tolerance = 3 * edge_length * edge_length + 1e-12;
        EXPECT_NEAR(test::mesh_quality(mesh).area / shape.area, 1, tolerance) << edge_length;
    }
}

// A sheet of worse triangles, or of another size, would bend and break differently.
TEST_P(EveryShape, HasGoodTrianglesOfTheTargetSize) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Mesh mesh = shape.generate(options(0.03, seed));
        const auto quality = test::mesh_quality(mesh);
        EXPECT_GT(quality.smallest_angle, 20);
        EXPECT_GT(quality.mean_smallest_angle, 48);
        EXPECT_NEAR(quality.mean_edge / 0.03, 1, 0.05);
        if (seed != 1) continue;
        std::cout << "| " << shape.name << " | " << mesh.number_of_faces() << " | " << quality.smallest_angle
                  << " | " << quality.mean_smallest_angle << " | " << quality.mean_edge / 0.03 << " |\n";
    }
}

TEST_P(EveryShape, HasItsVerticesOnTheSurface) {
    const Mesh mesh = shape.generate(options(0.05));
    for (const Vertex v : mesh.vertices()) EXPECT_LT(shape.gap(vector(mesh.point(v))), 1e-12);
}

// Repeated runs need the same mesh; runs with another seed need a different mesh.
TEST_P(EveryShape, DependsOnTheSeedAlone) {
    const Mesh first = shape.generate(options(0.05, 7)), again = shape.generate(options(0.05, 7));
    const Mesh other = shape.generate(options(0.05, 8));
    ASSERT_EQ(first.number_of_faces(), again.number_of_faces());
    for (const Vertex v : first.vertices()) ASSERT_EQ(first.point(v), again.point(v));
    for (const Halfedge h : first.halfedges()) ASSERT_EQ(first.target(h), again.target(h));
    std::size_t moved = 0;
    for (const Vertex v : first.vertices()) {
        moved += v.idx() >= other.num_vertices() || first.point(v) != other.point(v);
    }
    EXPECT_GT(moved, first.number_of_vertices() / 2);
}

INSTANTIATE_TEST_SUITE_P(Generate, EveryShape, ::testing::Range(std::size_t{0}, shapes().size()),
                         [](const auto& info) { return std::string(shapes()[info.param].name); });

// Rows of a lattice would make a sheet bend more easily in one direction than in another.
TEST(Generate, EdgesOfAFlatSheetPointAllWays) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        EXPECT_LT(test::mesh_quality(generate_rectangle(1, 1, options(0.02, seed))).order, 0.2);
        EXPECT_LT(test::mesh_quality(generate_disc(0.5, options(0.02, seed))).order, 0.2);
    }
    const GenerateOptions structured{0.02, Layout::structured, 1};
    EXPECT_GT(test::mesh_quality(generate_rectangle(1, 1, structured)).order, 0.3);
}

TEST(Generate, NormalsPointAsPromised) {
    const auto volume = [](const Mesh& mesh) {  // positive when closed and outward
        double sum = 0;
        for (const Face face : mesh.faces()) {
            std::vector<Vector3d> p;
            for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
                p.push_back(vector(mesh.point(v)));
            sum += p[0].dot(p[1].cross(p[2])) / 6;
        }
        return sum;
    };
    EXPECT_NEAR(volume(generate_sphere(1, options(0.1))), 4 * pi / 3, 0.05);
    EXPECT_GT(volume(generate_cylinder(1, 1, options(0.1))), 0);
    const auto up = [](const Mesh& mesh) {
        double sum = 0;
        for (const Face face : mesh.faces()) {
            std::vector<Vector3d> p;
            for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
                p.push_back(vector(mesh.point(v)));
            sum += (p[1] - p[0]).cross(p[2] - p[0]).z() / 2;
        }
        return sum;
    };
    EXPECT_NEAR(up(generate_rectangle(2, 1, options(0.1))), 2, 1e-12);
    EXPECT_GT(up(generate_disc(1, options(0.1))), 3);
    EXPECT_GT(up(generate_revolution(bowl_profile(), options(0.1))), 0);
}

TEST(Generate, RimsAreCirclesOfEvenlySpacedVertices) {
    const Mesh mesh = generate_revolution(plate_profile(), options(0.05));
    double shortest = 1e300, longest = 0;
    for (const Edge edge : mesh.edges()) {
        if (!mesh.is_border(edge)) continue;
        const Vector3d a = vector(mesh.point(mesh.vertex(edge, 0))),
                       b = vector(mesh.point(mesh.vertex(edge, 1)));
        EXPECT_NEAR(std::hypot(a.x(), a.y()), 1, 1e-14);
        shortest = std::min(shortest, (a - b).norm());
        longest = std::max(longest, (a - b).norm());
    }
    EXPECT_NEAR(shortest / longest, 1, 1e-12);
}

// A rounded edge would make the can weaker where it is bent most.
TEST(Generate, SharpCornersOfTheProfileHaveVertices) {
    const Mesh mesh = generate_revolution(std::vector<Vector2d>{{0, 0}, {0.5, 0}, {0.5, 1}}, options(0.05));
    int corner = 0;
    for (const Vertex v : mesh.vertices()) {
        const Vector3d p = vector(mesh.point(v));
        corner += p.z() == 0 && std::abs(std::hypot(p.x(), p.y()) - 0.5) < 1e-14;
    }
    EXPECT_EQ(corner, 63);  // 2 pi 0.5 / 0.05
}

// Supports and loads of a sector act on its corners and sides.
TEST(Generate, SectorsHaveTheirCornersAndStraightSides) {
    for (const Layout layout : {Layout::delaunay, Layout::structured}) {
        const Mesh mesh =
            generate_revolution(std::array{Vector2d(0.5, 1), Vector2d(0.8, 0)}, {0.1, layout, 1}, 90);
        int corners = 0, on_first = 0, on_last = 0;
        for (const Vertex v : mesh.vertices()) {
            const Vector3d p = vector(mesh.point(v));
            const bool first = p.y() == 0, last = std::abs(p.x()) < 1e-15;
            on_first += first;
            on_last += last;
            corners += (first || last) && (std::abs(p.z()) < 1e-15 || p.z() == 1);
            EXPECT_TRUE(mesh.is_border(v) || !(first || last));
        }
        EXPECT_EQ(corners, 4);
        EXPECT_EQ(on_first, 11);  // hypot(0.3, 1) / 0.1 edges
        EXPECT_EQ(on_last, 11);
    }
}

TEST(Generate, StructuredLayoutsAreGridsOfRightTriangles) {
    const GenerateOptions structured{0.1, Layout::structured, 1};
    const Mesh rectangle = generate_rectangle(1, 0.5, structured);
    EXPECT_EQ(rectangle.number_of_faces(), 100U);
    EXPECT_NEAR(test::mesh_quality(rectangle).smallest_angle, 45, 1e-9);
    const Mesh cylinder = generate_cylinder(0.5, 1, structured);
    EXPECT_EQ(cylinder.number_of_faces(), 2U * 31 * 10);
    EXPECT_TRUE(cylinder.is_valid(false));
    EXPECT_THROW(generate_disc(1, structured), Error);
    EXPECT_THROW(generate_sphere(1, structured), Error);
    EXPECT_THROW(generate_revolution(plate_profile(), structured), Error);
}

TEST(Generate, RefusesSizesThatMakeNoMesh) {
    const double nan = std::nan("");
    EXPECT_THROW(generate_rectangle(0, 1, options(0.1)), Error);
    EXPECT_THROW(generate_rectangle(1, -1, options(0.1)), Error);
    EXPECT_THROW(generate_rectangle(nan, 1, options(0.1)), Error);
    EXPECT_THROW(generate_rectangle(1, 1, options(0)), Error);
    EXPECT_THROW(generate_rectangle(1, 1, options(nan)), Error);
    EXPECT_THROW(generate_rectangle(1, 1, options(2)), Error);
    EXPECT_THROW(generate_disc(0, options(0.1)), Error);
    EXPECT_THROW(generate_disc(1, options(1.1)), Error);
    EXPECT_THROW(generate_cylinder(1, 0, options(0.1)), Error);
    EXPECT_THROW(generate_sphere(-1, options(0.1)), Error);
    const auto revolve = [](std::vector<Vector2d> profile) {
        return generate_revolution(profile, options(0.1));
    };
    EXPECT_THROW(revolve({}), Error);
    EXPECT_THROW(revolve({{1, 0}}), Error);
    EXPECT_THROW(revolve({{1, 0}, {1, 0}}), Error);
    EXPECT_THROW(revolve({{1, 0}, {0, 1}, {1, 2}}), Error);
    EXPECT_THROW(revolve({{0, 0}, {0, 1}}), Error);
    EXPECT_THROW(revolve({{1, 0}, {-1, 1}}), Error);
    EXPECT_THROW(revolve({{1, 0}, {nan, 1}}), Error);
    EXPECT_THROW(revolve({{1, 0}, {0.01, 1}, {1, 2}}), Error);  // a neck narrower than an edge
    EXPECT_THROW(revolve({{0.2, 0}, {0.2, 100}}), Error);       // 500 radii long
    const auto sector = [](std::vector<Vector2d> profile, double degrees) {
        return generate_revolution(profile, options(0.1), degrees);
    };
    EXPECT_THROW(sector({{0, 0}, {1, 0}}, 90), Error);
    EXPECT_THROW(sector({{1, 0}, {1, 1}}, 0), Error);
    EXPECT_THROW(sector({{1, 0}, {1, 1}}, 361), Error);
}

// The coarsest meshes that a user may request must be manifolds of good triangles, too.
TEST(Generate, CoarseMeshesAreManifoldsToo) {
    for (const Mesh& mesh : {generate_rectangle(1, 1, options(1)), generate_disc(1, options(1)),
                             generate_sphere(1, options(1)), generate_cylinder(1, 1, options(1))}) {
        EXPECT_TRUE(mesh.is_valid(false));
        EXPECT_GT(test::mesh_quality(mesh).smallest_angle, 20);
    }
}

}  // namespace
}  // namespace sherd
