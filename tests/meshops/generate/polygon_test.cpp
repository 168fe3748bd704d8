// SPDX-License-Identifier: GPL-3.0-or-later
// Flat sheets of any outline: the mesh must cover the given region with good triangles, and impossible
// outlines must be refused with their place.
#include "meshops/generate/polygon.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_quality.h"

namespace sherd {
namespace {

using Eigen::Vector2d;

Polyline rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Polyline circle(double x, double y, double radius, int points = 200) {
    Polyline line;
    for (int i = 0; i < points; ++i)
        line.emplace_back(x + radius * std::cos(2 * std::numbers::pi * i / points),
                          y + radius * std::sin(2 * std::numbers::pi * i / points));
    return line;
}

int characteristic(const Mesh& mesh) {
    return int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
}

struct Region {
    const char* name;
    Polygon polygon;
    double area;
    int characteristic, loops;
    double smallest_angle = 22;
};

std::vector<Region> regions() {
    const Polyline ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    Polyline clockwise(ell.rbegin(), ell.rend());
    return {
        {"square", {rectangle(0, 0, 1, 1), {}, {}}, 1, 1, 1},
        {"ell", {ell, {}, {}}, 3, 1, 1},
        {"clockwise ell", {clockwise, {}, {}}, 3, 1, 1},
        {"disc", {circle(0, 0, 0.5), {}, {}}, std::numbers::pi / 4, 1, 1},
        {"plate with holes",
         {rectangle(-1, -1, 2, 2), {circle(0.3, 0.2, 0.3), rectangle(-0.8, -0.8, 0.4, 0.4)}, {}},
         4 - 0.09 * std::numbers::pi - 0.16,
         -1,
         3},
        {"plate with a slit", {rectangle(0, 0, 1, 1), {}, {{{0.3, 0.5}, {0.7, 0.5}}}}, 1, 0, 2},
        {"notched plate", {rectangle(0, 0, 1, 1), {}, {{{0.5, 0}, {0.5, 0.4}}}}, 1, 1, 1},
        {"cut in two", {rectangle(0, 0, 1, 1), {}, {{{0, 0.2}, {1, 0.7}}}}, 1, 2, 2},
        {"slit from hole to rim",
         {circle(0, 0, 1), {circle(0, 0, 0.5)}, {{{0.5, 0}, {1, 0}}}},
         0.75 * std::numbers::pi,
         1,
         1},
        {"crossing slits",
         {rectangle(0, 0, 1, 1), {}, {{{0.2, 0.2}, {0.8, 0.8}}, {{0.2, 0.8}, {0.8, 0.2}}}},
         1,
         0,
         2},
        {"narrow angle", {{{0, 0}, {2, 0}, {2, 0.6}}, {}, {}}, 0.6, 1, 1, 15},
    };
}

TEST(Polygon, MeshesCoverTheRegionWithGoodTriangles) {
    for (const Region& region : regions()) {
        SCOPED_TRACE(region.name);
        for (const unsigned seed : {1u, 2u}) {
            const Mesh mesh = generate_polygon(region.polygon, {0.05, Layout::delaunay, seed});
            ASSERT_TRUE(mesh.is_valid());
            const test::MeshQuality quality = test::mesh_quality(mesh);
            EXPECT_NEAR(quality.area, region.area, 4e-3 * region.area);
            EXPECT_EQ(characteristic(mesh), region.characteristic);
            EXPECT_EQ(measure(mesh).boundary_loops, region.loops);
            EXPECT_NEAR(quality.mean_edge, 0.05, 0.05 * 0.06);
            EXPECT_LT(measure(mesh).largest_edge, 0.05 * 2);
            EXPECT_GT(quality.smallest_angle, region.smallest_angle);
            for (const Face face : mesh.faces()) {
                const Halfedge h = mesh.halfedge(face);
                const auto a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)),
                           c = mesh.point(mesh.target(mesh.next(h)));
                ASSERT_GT(CGAL::cross_product(b - a, c - a).z(), 0) << "a normal points down";
            }
        }
    }
}

// Straight sides must be exact, whatever points describe them.
TEST(Polygon, CornersAndSidesAreExact) {
    Polygon polygon{rectangle(0, 0, 1, 1), {}, {}};
    const Mesh mesh = generate_polygon(polygon, {0.1, Layout::delaunay, 1});
    EXPECT_NEAR(measure(mesh).area, 1, 1e-12);
    polygon.outline.insert(polygon.outline.begin() + 1, {0.01234, 0});
    const Mesh same = generate_polygon(polygon, {0.1, Layout::delaunay, 1});
    EXPECT_EQ(same.number_of_vertices(), mesh.number_of_vertices());
}

/// Returns the number of vertices that coincide with another one, and the number of different places that
/// vertices have on the segment from a to b.
std::pair<int, int> doubled_and_on(const Mesh& mesh, const Vector2d& a, const Vector2d& b) {
    std::multiset<std::pair<double, double>> places;
    int doubled = 0;
    std::set<std::pair<double, double>> on;
    for (const Vertex v : mesh.vertices()) {
        const Vector2d p = position(mesh, v).head<2>();
        places.insert({p.x(), p.y()});
        if (distance_from_side(p, a, b) < 1e-9) on.insert({p.x(), p.y()});
    }
    for (const Vertex v : mesh.vertices())
        doubled += places.count({mesh.point(v).x(), mesh.point(v).y()}) > 1;
    return {doubled, int(on.size())};
}

TEST(Polygon, SlitsAreOpenButForTheirInnerEnds) {
    const Vector2d a(0.3, 0.5), b(0.7, 0.55);
    const Mesh inside = generate_polygon({rectangle(0, 0, 1, 1), {}, {{a, b}}}, {0.05, Layout::delaunay, 1});
    auto [doubled, on] = doubled_and_on(inside, a, b);
    EXPECT_EQ(on, 9);
    EXPECT_EQ(doubled, 2 * (on - 2));
    const Vector2d rim(0.5, 1), tip(0.5, 0.6);
    // The slit is given from its tip to the rim, and its end is off the outline by the round-off of a
    // decimal.
    const Mesh notch = generate_polygon({rectangle(0, 0, 1, 1), {}, {{tip, rim + Vector2d(0, 1e-9)}}},
                                        {0.05, Layout::delaunay, 1});
    std::tie(doubled, on) = doubled_and_on(notch, tip, rim);
    EXPECT_EQ(doubled, 2 * (on - 1));
    EXPECT_EQ(connected_components(notch).count, 1u);
    const Mesh short_slit = generate_polygon({rectangle(0, 0, 1, 1), {}, {{{0.4, 0.5}, {0.46, 0.5}}}},
                                             {0.05, Layout::delaunay, 1});
    EXPECT_EQ(measure(short_slit).boundary_loops, 2) << "one edge would not open";
}

// Impossible polygons must be reported with the place, and must not reach the triangulation.
TEST(Polygon, FaultsAreNamed) {
    const Polyline unit = rectangle(0, 0, 1, 1);
    const auto fault = [](const Polygon& polygon) {
        const auto found = fault_of(polygon);
        return found ? found->part + ": " + found->what : "none";
    };
    const auto begins = [](const std::string& text, const std::string& wanted) {
        EXPECT_TRUE(text.starts_with(wanted)) << text;
    };
    begins(fault({{{0, 0}, {1, 0}}, {}, {}}), "outline: has 2 points");
    begins(fault({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}, {}}), "outline: crosses or touches itself");
    begins(fault({{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {}, {}}),
           "outline: has the same point twice, as points 4 and 1");
    begins(fault({unit, {rectangle(2, 2, 1, 1)}, {}}), "holes: hole 1 is outside");
    begins(fault({unit, {rectangle(-1, -1, 3, 3)}, {}}), "holes: hole 1 is outside");
    begins(fault({unit, {rectangle(0.5, 0.2, 0.5, 0.2)}, {}}),
           "holes: hole 1 crosses or touches the outline");
    begins(fault({unit, {rectangle(0.2, 0.2, 0.5, 0.5), rectangle(0.3, 0.3, 0.1, 0.1)}, {}}),
           "holes: hole 2 meets hole 1");
    begins(fault({unit, {rectangle(0.3, 0.3, 0.1, 0.1), rectangle(0.2, 0.2, 0.5, 0.5)}, {}}),
           "holes: hole 2 meets hole 1");
    begins(fault({unit, {}, {{{2, 2}, {3, 3}}}}), "slits: slit 1 is outside");
    begins(fault({unit, {}, {{{0.5, 0.5}, {1.5, 0.5}}}}), "slits: slit 1 crosses or touches an outline");
    begins(fault({unit, {}, {{{0.5, 0}, {1, 0}}}}), "slits: slit 1");
    begins(fault({unit, {rectangle(0.2, 0.2, 0.5, 0.5)}, {{{0.3, 0.3}, {0.4, 0.4}}}}),
           "slits: slit 1 is outside");
    begins(fault({unit, {}, {{{0.2, 0.5}, {0.6, 0.5}}, {{0.4, 0.5}, {0.8, 0.5}}}}),
           "slits: slit 2 runs along slit 1");
    begins(fault({unit, {}, {{{0.2, 0.5}, {0.6, 0.5}, {0.6, 0.8}, {0.4, 0.2}}}}),
           "slits: slit 1 meets itself");
    EXPECT_EQ(fault({unit, {rectangle(0.2, 0.2, 0.5, 0.5)}, {{{0, 0}, {0.2, 0.2}}}}), "none");
    EXPECT_THROW(generate_polygon({{{0, 0}, {1, 0}}, {}, {}}, {}), Error);
    EXPECT_THROW(generate_polygon({unit, {circle(0.5, 0.5, 0.01)}, {}}, {0.1, Layout::delaunay, 1}), Error)
        << "edges are too long for the hole";
}

}  // namespace
}  // namespace sherd
