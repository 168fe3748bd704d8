// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/breaking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshops/error.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

/// Flat strip with the strength that a test sets, and measures of its hinges.
class Breaking : public testing::Test {
  protected:
    Breaking() { set(uniform_strength(0.1)); }

    void set(const Strength& strength) {
        SheetInput flat;
        flat.mesh = test::grid(12, 4);
        flat.material = {1000, 0.01, 1e7, 0.3};
        flat.axes.assign(flat.mesh.number_of_faces(), Vector3d::UnitX());
        flat.strength = strength;
        sheet = std::make_unique<BreakableShell>(std::vector{flat});
        measures.bending = measures.strain = measures.stress =
            VectorXd::Zero(static_cast<Eigen::Index>(sheet->mechanics().hinges.size()));
    }
    Edge edge_at(unsigned a, unsigned b) const {
        return sheet->mesh().edge(sheet->mesh().halfedge(Vertex(a), Vertex(b)));
    }
    double& strain_at(unsigned a, unsigned b) { return measures.strain[sheet->hinge_of_edge(edge_at(a, b))]; }

    std::unique_ptr<BreakableShell> sheet;
    HingeMeasures measures;
};

std::vector<Edge> sorted(std::vector<Edge> edges) {
    std::sort(edges.begin(), edges.end());
    return edges;
}

// A stage breaks only the most overloaded hinges; their neighbours are evaluated again after the sheet has
// relaxed. The paper's rule breaks all overloaded hinges.
TEST_F(Breaking, PicksTheMostOverloadedWithinTwoRings) {
    strain_at(15, 28) = 0.3;   // worst of the left half
    strain_at(16, 29) = 0.2;   // a ring away from the worst
    strain_at(22, 35) = 0.15;  // far away
    strain_at(36, 49) = 0.05;  // not overloaded
    EXPECT_EQ(most_overloaded_edges(*sheet, measures), sorted({edge_at(15, 28), edge_at(22, 35)}));
    EXPECT_EQ(overloaded_edges(*sheet, measures),
              sorted({edge_at(15, 28), edge_at(16, 29), edge_at(22, 35)}));
    strain_at(22, 35) = -0.3;  // presses the edge together
    EXPECT_EQ(most_overloaded_edges(*sheet, measures), std::vector{edge_at(15, 28)});
    measures.strain.setConstant(0.2);  // equal overloads everywhere break some hinges, and not all
    const std::size_t count = most_overloaded_edges(*sheet, measures).size();
    EXPECT_GT(count, 0u);
    EXPECT_LT(count, sheet->mechanics().hinges.size() / 20);
}

// A hinge at a crack tip fails before an equally strained one elsewhere, but not by the paper's rule.
TEST_F(Breaking, ContinuesACrackBelowTheStrength) {
    sheet->fail(std::array{edge_at(3, 16)});  // from the boundary inwards: it opens up to its tip, 16
    EXPECT_TRUE(sheet->cracks().is_tip(Vertex(16)));
    EXPECT_FALSE(sheet->cracks().is_tip(Vertex(3)));
    strain_at(16, 29) = 0.08;
    strain_at(22, 35) = 0.08;
    EXPECT_EQ(most_overloaded_edges(*sheet, measures), std::vector{edge_at(16, 29)});
    EXPECT_DOUBLE_EQ(overload(*sheet, measures, edge_at(16, 29), true), 0.8 / 0.7);
    EXPECT_DOUBLE_EQ(overload(*sheet, measures, edge_at(22, 35), true), 0.8);
    EXPECT_TRUE(overloaded_edges(*sheet, measures).empty());
}

// Recordings and JSON have no infinity: without strength the overload must still be finite.
TEST_F(Breaking, WhatHasNoStrengthIsNotOverloadedInfinitely) {
    set(uniform_strength(0, Measure::strain));
    strain_at(16, 29) = 0.2;
    const double of_it = overload(*sheet, measures, edge_at(16, 29), true);
    EXPECT_TRUE(std::isfinite(of_it) && of_it > 1) << of_it;
    EXPECT_EQ(most_overloaded_edges(*sheet, measures), std::vector{edge_at(16, 29)});
}

// A sheet whose measure is stress must not fracture by its strain, nor the other way round.
TEST_F(Breaking, ComparesByTheMeasureOfTheSheet) {
    for (const Measure measure : {Measure::strain, Measure::stress, Measure::bending}) {
        set(uniform_strength(0.1, measure));
        const Edge edge = edge_at(15, 28);
        const Index hinge = sheet->hinge_of_edge(edge);
        measures.strain[hinge] = measure == Measure::strain ? 0.2 : 0;
        measures.stress[hinge] = measure == Measure::stress ? 0.3 : 0;
        measures.bending[hinge] = measure == Measure::bending ? 0.4 : 0;
        EXPECT_DOUBLE_EQ(overload(*sheet, measures, edge, true), measure == Measure::strain   ? 2
                                                                 : measure == Measure::stress ? 3
                                                                                              : 4);
    }
}

// When an edge along x opens, it is pulled along y; an edge along y is pulled along x.
TEST_F(Breaking, IsStrongerAlongTheStrongAxis) {
    Strength strength;
    strength.along = 0.4;
    strength.across = 0.1;
    set(strength);
    EXPECT_NEAR(sheet->strength(edge_at(15, 16)), 0.1, 1e-15) << "along x, pulled across the axis";
    EXPECT_NEAR(sheet->strength(edge_at(15, 28)), 0.4, 1e-15) << "along y, pulled along the axis";
}

// Toughness has directions, too, and a factor for each edge.
TEST_F(Breaking, IsTougherAlongTheStrongAxis) {
    SheetInput flat;
    flat.mesh = test::grid(12, 4);
    flat.material = {1000, 0.01, 1e7, 0.3};
    flat.axes.assign(flat.mesh.number_of_faces(), Vector3d::UnitX());
    flat.strength = uniform_strength(1e7, Measure::stress);
    flat.toughness = {.value = 4e6, .speed_limit = 100, .across = 1e6};
    flat.toughness.factors.assign(flat.mesh.number_of_edges(), 0.5);
    sheet = std::make_unique<BreakableShell>(std::vector{flat});
    EXPECT_NEAR(sheet->toughness(edge_at(15, 16)).value, 5e5, 1e-7) << "along x, pulled across the axis";
    EXPECT_NEAR(sheet->toughness(edge_at(15, 28)).value, 2e6, 1e-7) << "along y, pulled along the axis";
    EXPECT_EQ(sheet->toughness(edge_at(15, 28)).speed_limit, 100);
    EXPECT_TRUE(sheet->toughness(edge_at(15, 28)).given());
    EXPECT_FALSE(sheet->has_directed_strength(edge_at(15, 28)));
    flat.toughness.factors.pop_back();
    EXPECT_THROW(BreakableShell({flat}), Error);
    flat.toughness.factors.clear();
    flat.axes.clear();
    EXPECT_THROW(BreakableShell({flat}), Error) << "a direction, and no axes";
}

TEST_F(Breaking, RefusesStrengthsThatDoNotFitTheMesh) {
    Strength strength = uniform_strength(1);
    strength.factors = {1, 2, 3};
    EXPECT_THROW(set(strength), Error);
    SheetInput flat;
    flat.mesh = test::grid(2, 2);
    flat.material = {1000, 0.01, 1e7, 0.3};
    flat.strength.along = 1;  // strength with a direction, but no axes
    EXPECT_THROW(BreakableShell({flat}), Error);
}

}  // namespace
}  // namespace sherd
