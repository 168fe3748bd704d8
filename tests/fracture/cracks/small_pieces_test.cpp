// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces below the smallest size. If one came off, or an edge that holds no such piece were kept, a picture
// would have the dust that was excluded, or cracks with dead ends.
#include "fracture/cracks/small_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

/// Squares of 1 m, of two triangles each, in 13 columns of vertices.
class SmallPieces : public testing::Test {
  protected:
    SmallPieces() { make(1.1); }
    void make(double smallest) {
        SheetInput flat;
        flat.mesh = test::grid(12, 4);
        flat.material = {1000, 0.01, 1e7, 0.3};
        flat.strength = uniform_strength(0.1);
        flat.art_direction.smallest = smallest;
        sheet = std::make_unique<BreakableShell>(std::vector{flat});
    }
    Edge edge_at(unsigned a, unsigned b) const {
        return sheet->mesh().edge(sheet->mesh().halfedge(Vertex(a), Vertex(b)));
    }
    /// Whether the failure of one edge after some others separates a piece smaller than a square of side
    /// `smallest` (m).
    bool separates(Edge edge, double smallest, const std::vector<Edge>& before = {}) const {
        std::vector<char> gone(sheet->mesh().number_of_edges(), 0);
        for (const Edge one : before) gone[one] = 1;
        return separates_small_piece(*sheet, edge, smallest, gone);
    }
    // The square in the corner hangs by its two inner sides.
    Edge right() const { return edge_at(1, 14); }
    Edge top() const { return edge_at(13, 14); }

    std::unique_ptr<BreakableShell> sheet;
};

TEST_F(SmallPieces, AreToldByTheirAreaWhenTheLastEdgeGoes) {
    EXPECT_FALSE(separates(right(), 1.1)) << "it still hangs by its other side";
    EXPECT_TRUE(separates(top(), 1.1, {right()}));
    EXPECT_TRUE(separates(right(), 1.1, {top()}));
    EXPECT_FALSE(separates(top(), 0.99, {right()})) << "a square metre is large enough";
    EXPECT_FALSE(separates(edge_at(30, 43), 1.1)) << "inside the sheet nothing comes off";
}

TEST_F(SmallPieces, AreToldFromEitherSideOfACrackThatIsOpen) {
    sheet->fail(std::array{right()});
    EXPECT_TRUE(separates(top(), 1.1));
    EXPECT_FALSE(separates(top(), 0.99));
    // Across the middle the sheet falls into two halves of 24 m^2.
    std::vector<Edge> cut{edge_at(6, 19), edge_at(19, 32), edge_at(32, 45)};
    EXPECT_FALSE(separates(edge_at(45, 58), 4.8, cut));
    EXPECT_TRUE(separates(edge_at(45, 58), 5, cut));
}

// Two edges together would separate a piece: only one of them may fail.
TEST_F(SmallPieces, AreKeptOnByTheLastEdgeAndCountedOnce) {
    const std::vector<Edge> both{right(), top()};
    EXPECT_EQ(prevent_small_pieces(*sheet, both), 1);
    EXPECT_EQ(sheet->strength(right()), 0.1);
    EXPECT_EQ(sheet->strength(top()), std::numeric_limits<double>::infinity());
    EXPECT_EQ(prevent_small_pieces(*sheet, std::vector{right()}), 0);
    EXPECT_EQ(prevent_small_pieces(*sheet, {}), 0);
    make(0);
    EXPECT_EQ(prevent_small_pieces(*sheet, both), 0) << "any piece may come off";
}

/// Tilted disc that falls on a floor, at 4 m/s.
Simulation thrown_disc(const ArtDirection& art_direction) {
    SheetInput plate;
    plate.mesh = generate_disc(0.1, {0.012, Layout::delaunay, 1});
    plate.material = {2400, 0.004, 7e10, 0.2};
    plate.strength = uniform_strength(0.2);
    plate.art_direction = art_direction;
    for (const Vertex vertex : plate.mesh.vertices()) {
        const Point p = plate.mesh.point(vertex);
        plate.mesh.point(vertex) = Point(std::cos(0.3) * p.x(), p.y(), 0.035 + std::sin(0.3) * p.x());
    }
    plate.velocity = Vector3d(0, 0, -4);
    SimulationOptions options;
    options.stepper.contact.obstacles = {test::floor()};
    return Simulation({plate}, options);
}

double smallest_area(const Snapshot& frame, Index fragments) {
    std::vector<double> area(fragments, 0);
    for (std::size_t f = 0; f < frame.faces.size(); ++f) area[frame.face_fragment[f]] += frame.rest.area[f];
    return *std::ranges::min_element(area);
}

// A run must have no fragment below the smallest size, and must report how often it prevented one.
TEST(ArtDirection, NoPieceOfARunIsBelowTheSmallest) {
    for (const double smallest : {0.0, 0.03}) {
        Simulation simulation = thrown_disc({.smallest = smallest});
        Index fragments = 1;
        for (int i = 0; i < 120; ++i) fragments = simulation.step().fragments;
        const double least = std::sqrt(smallest_area(simulation.snapshot(), fragments));
        EXPECT_GT(fragments, 1);
        if (smallest > 0) {
            EXPECT_GE(least, smallest);
            EXPECT_GT(simulation.prevented_failures(), 0);
        } else {
            EXPECT_LT(least, 0.03) << "crumbs, without it";
            EXPECT_EQ(simulation.prevented_failures(), 0);
        }
    }
}

// Nothing may fail before the given time, and then something must.
TEST(ArtDirection, NothingFailsBeforeItsTime) {
    Simulation simulation = thrown_disc({});
    double first = 0;
    while (first == 0)
        if (simulation.step(); !simulation.take_events().failures.empty()) first = simulation.time();
    Simulation later = thrown_disc({.after = first + 4.5e-4});
    double broken = 0;
    for (int i = 0; i < 200 && broken == 0; ++i) {
        EXPECT_GT(later.step().peak_strain, 0);
        if (!later.take_events().failures.empty()) broken = later.time();
    }
    EXPECT_GE(broken, first + 4.5e-4);
    EXPECT_LT(broken, first + 2e-2);
}

}  // namespace
}  // namespace sherd
