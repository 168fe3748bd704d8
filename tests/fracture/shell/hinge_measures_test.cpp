// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/hinge_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/shell_energies.h"
#include "meshops/generate/generate.h"

namespace sherd {
namespace {

constexpr double thickness = 0.002, young = 1e7, poisson = 0.3;

/// Squared cosine between x and the direction across the hinge's edge.
double across_of(const BreakableShell& sheet, std::size_t hinge) {
    const auto& vertices = sheet.mechanics().hinges[hinge].vertices;
    const Vector3d edge = sheet.mechanics().rest.col(vertices[1]) - sheet.mechanics().rest.col(vertices[0]);
    return std::pow(edge.y() / edge.norm(), 2);
}

Positions rolled(const Positions& flat, double curvature) {
    Positions x = flat;
    x.row(0) = (curvature * flat.row(0).array()).sin() / curvature;
    x.row(2) = (1 - (curvature * flat.row(0).array()).cos()) / curvature;
    return x;
}

class HingeMeasuresOfASquare : public testing::Test {
  protected:
    HingeMeasuresOfASquare() {
        SheetInput square;
        square.mesh = generate_rectangle(0.3, 0.3, {0.01, Layout::delaunay, 5});
        square.material = {1000, thickness, young, poisson};
        sheet = std::make_unique<BreakableShell>(std::vector{square});
        flat = sheet->mechanics().rest;
    }
    std::unique_ptr<BreakableShell> sheet;
    Positions flat;
};

// In a sheet that is stretched along x, the strain across an edge must be the resolved strain, and the
// stress that of plane stress.
TEST_F(HingeMeasuresOfASquare, ResolveStretchAcrossTheEdge) {
    const double stretch = 2e-4;
    Positions x = flat;
    x.row(0) *= 1 + stretch;
    const HingeMeasures measures = hinge_measures(*sheet, x);
    const double modulus = young / (1 - poisson * poisson);
    for (std::size_t i = 0; i < sheet->mechanics().hinges.size(); ++i) {
        const double across = across_of(*sheet, i), along = 1 - across;
        EXPECT_NEAR(measures.strain[i], across * stretch / (thickness / 2), 2e-3 * stretch / (thickness / 2));
        EXPECT_NEAR(measures.stress[i], modulus * stretch * (across + poisson * along),
                    2e-3 * modulus * stretch);
        EXPECT_NEAR(measures.bending[i], 0, 1e-9);
    }
}

// In a sheet that is rolled into a cylinder, up or down, the measures must be the curvature and the stress
// of the stretched surface.
TEST_F(HingeMeasuresOfASquare, SeeTheStretchedSurfaceOfABend) {
    const double stress = young / (1 - poisson * poisson) * 0.5 * thickness / 2;
    for (const double curvature : {0.5, -0.5}) {
        const HingeMeasures measures = hinge_measures(*sheet, rolled(flat, curvature));
        double strain = 0, pull = 0;
        int count = 0;
        for (std::size_t i = 0; i < sheet->mechanics().hinges.size(); ++i) {
            if (across_of(*sheet, i) < 0.98) continue;
            strain += measures.strain[i];
            pull += measures.stress[i];
            ++count;
        }
        EXPECT_NEAR(strain / count, 0.5, 0.05);
        EXPECT_NEAR(pull / count, stress, 0.1 * stress);
    }
}

// Membrane strains that are given, as by arcs, are more exact than those of the corners and must be used.
TEST_F(HingeMeasuresOfASquare, TakeTheStretchThatTheyAreGiven) {
    const double stretch = 2e-4;
    Positions x = flat;
    x.row(0) *= 1 + stretch;
    const HingeMeasures own = hinge_measures(*sheet, x);
    Eigen::Matrix3Xd stretches(3, sheet->mechanics().triangles.size());
    for (std::size_t f = 0; f < sheet->mechanics().triangles.size(); ++f) {
        const TriangleStencil& triangle = sheet->mechanics().triangles[f];
        stretches.col(static_cast<Eigen::Index>(f)) =
            green_strain(triangle.membrane, columns(x, triangle.vertices));
    }
    const HingeMeasures given = hinge_measures(*sheet, flat, {}, stretches);
    EXPECT_LT((given.strain - own.strain).norm(), 1e-9 * own.strain.norm());
    EXPECT_LT((given.stress - own.stress).norm(), 1e-9 * own.stress.norm());
}

// Plastic curvature of metal is strain without stress.
TEST_F(HingeMeasuresOfASquare, WhatFacesKeepIsStrainWithoutStress) {
    const auto faces = static_cast<Eigen::Index>(sheet->mechanics().triangles.size());
    const Eigen::Matrix3Xd none = Eigen::Matrix3Xd::Zero(3, faces),
                           bent = Vector3d(0.3, -0.2, 0.1).replicate(1, faces);
    const HingeMeasures elastic = hinge_measures(*sheet, flat, bent),
                        kept = hinge_measures(*sheet, flat, none, {}, bent);
    EXPECT_GT(kept.strain.minCoeff(), 0);
    EXPECT_EQ(kept.strain, elastic.strain);
    EXPECT_LT(kept.stress.norm(), 1e-9 * elastic.stress.norm());
}

// Bending and stretch must add up at the surface, and must cancel where they are opposite.
TEST_F(HingeMeasuresOfASquare, AddBendingAndStretch) {
    Positions both = rolled(flat, 0.5);
    const double squeeze = -0.5 * thickness / 2;
    both.row(0) *= 1 + squeeze;
    both.row(2) *= 1 + squeeze;
    const HingeMeasures bent = hinge_measures(*sheet, rolled(flat, 0.5)), less = hinge_measures(*sheet, both);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < sheet->mechanics().hinges.size(); ++i) {
        if (across_of(*sheet, i) < 0.98) continue;
        before += bent.strain[i];
        after += less.strain[i];
    }
    EXPECT_LT(std::abs(after), 0.1 * before);
}

// Hinges at edges that break by toughness are measured one by one: recordings must have the same values as
// if all hinges were measured.
TEST_F(HingeMeasuresOfASquare, OfASingleHingeAreThoseOfAll) {
    std::vector<Edge> gone;
    for (std::size_t hinge = 5; hinge < sheet->mechanics().hinges.size(); hinge += 40)
        gone.push_back(sheet->edge_of_hinge(hinge));
    sheet->fail(gone);
    Positions x = rolled(sheet->mechanics().rest, 3);
    x.row(1) *= 1.003;
    for (const BendingModel model : {BendingModel::coupled, BendingModel::cubic})
        for (const MembraneModel membrane : {MembraneModel::constant_strain, MembraneModel::arc}) {
            ShellEnergyOptions options{.bending = {.model = model}, .membrane = membrane};
            options.yields = {1e4};
            const ShellEnergies energies(sheet->mechanics(), options);
            const HingeMeasures all =
                hinge_measures(*sheet, x, energies.coupled_curvatures(x), energies.face_strains(x),
                               energies.plastic_curvatures(x));
            for (Index hinge = 0; hinge < static_cast<Index>(all.strain.size()); ++hinge) {
                const std::array<Index, 2> faces = faces_of_hinge(*sheet, hinge);
                const HingeMeasure one =
                    hinge_measure(*sheet, hinge, x, energies.coupled_curvatures(x, faces),
                                  energies.face_strains(x, faces), energies.plastic_curvatures(x, faces));
                ASSERT_EQ(one.bending, all.bending[hinge]) << hinge;
                ASSERT_EQ(one.strain, all.strain[hinge]) << hinge;
                ASSERT_EQ(one.stress, all.stress[hinge]) << hinge;
            }
        }
}

}  // namespace
}  // namespace sherd
