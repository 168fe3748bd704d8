// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/breakable_shell.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

SheetInput input(Mesh mesh) {
    SheetInput sheet;
    sheet.mesh = std::move(mesh);
    sheet.material = {2400, 0.01, 1e9, 0.2};
    sheet.strength = uniform_strength(0.5);
    return sheet;
}

/// Stencils must be those of a sheet built from the fractured mesh.
void expect_stencils_of_the_mesh(const BreakableShell& sheet) {
    const auto faces = test::triangles_of(sheet.mesh());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int i = 0; i < 3; ++i) RC_ASSERT(sheet.mechanics().triangles[f].vertices[i] == faces[f][i]);
    std::size_t hinges = 0;
    for (const Edge edge : sheet.mesh().edges()) {
        const Index hinge = sheet.hinge_of_edge(edge);
        RC_ASSERT((hinge >= 0) == (sheet.cracks().state(edge) == EdgeState::interior));
        if (hinge < 0) continue;
        ++hinges;
        RC_ASSERT(sheet.edge_of_hinge(hinge).idx() == edge.idx());
        const HingeStencil& stencil = sheet.mechanics().hinges[hinge];
        RC_ASSERT(stencil.vertices[0] == static_cast<Index>(sheet.mesh().vertex(edge, 0)) ||
                  stencil.vertices[0] == static_cast<Index>(sheet.mesh().vertex(edge, 1)));
        const RestHinge fresh = rest_hinge(columns(sheet.mechanics().rest, stencil.vertices));
        RC_ASSERT(fresh.area == stencil.rest.area);
        RC_ASSERT(fresh.angle == stencil.rest.angle);
    }
    RC_ASSERT(hinges == sheet.mechanics().hinges.size());
}

// A crack may change only connectivity: mass, rest shape, positions and velocities must stay.
RC_GTEST_PROP(BreakableShell, CrackCarriesEverythingOver, ()) {
    static const Mesh disc = generate_disc(0.1, {0.025, Layout::delaunay, 3});
    SheetInput start = input(disc);
    start.spin = Vector3d(1, 2, 3);
    start.pinned = {0, 5};
    BreakableShell sheet({start});
    const Shell before = sheet.mechanics();
    for (int batch = 0; batch < 3; ++batch) {
        std::vector<Edge> edges;
        for (const Edge edge : sheet.mesh().edges())
            if (sheet.cracks().state(edge) == EdgeState::interior && *rc::gen::inRange(0, 4) == 0)
                edges.push_back(edge);
        sheet.fail(edges);
        expect_stencils_of_the_mesh(sheet);
    }
    const Shell& after = sheet.mechanics();
    RC_ASSERT(std::abs(after.mass.sum() - before.mass.sum()) <= 1e-14 * before.mass.sum());
    RC_ASSERT(std::abs(after.footprint.sum() - before.footprint.sum()) <= 1e-13 * before.footprint.sum());
    RC_ASSERT(after.mass.minCoeff() > 0);
    for (const Vertex v : sheet.mesh().vertices()) {
        const Vertex origin = sheet.cracks().original(v);
        RC_ASSERT(after.rest.col(v) == before.rest.col(origin));
        RC_ASSERT(after.velocity.col(v) == before.velocity.col(origin));
        RC_ASSERT(after.fixed[v] == before.fixed[origin]);
    }
}

TEST(BreakableShell, WeighsAreaTimesThicknessTimesDensityAndMovesRigidly) {
    SheetInput first = input(test::grid(3, 2)), second = input(test::grid(1, 1));
    second.velocity = Vector3d(0, 0, -2);
    second.spin = Vector3d(0, 0, 4);
    second.strength = {};
    const BreakableShell sheet({first, second});
    EXPECT_NEAR(sheet.mechanics().mass.sum(), 7 * 0.01 * 2400, 1e-9);
    EXPECT_EQ(sheet.face_sheet()[11], 0);
    EXPECT_EQ(sheet.face_sheet()[12], 1);
    const Vector3d momentum = linear_momentum(sheet.mechanics());
    EXPECT_NEAR(momentum.z(), -2 * 24, 1e-9);
    EXPECT_NEAR(momentum.x(), 0, 1e-9);
    const Edge last = sheet.edge_of_hinge(sheet.mechanics().hinges.size() - 1);
    EXPECT_EQ(sheet.strength(last), std::numeric_limits<double>::infinity());
    EXPECT_EQ(sheet.strength(sheet.edge_of_hinge(0)), 0.5);
}

// A sheet whose material axis is lost, or taken for that of another sheet, bends like another material.
TEST(BreakableShell, HingesAndTrianglesHaveTheStiffnessOfTheirAxis) {
    SheetInput iron = input(test::grid(1, 1)), cloth = input(test::grid(3, 2));
    cloth.material.young1 = 1e8;
    cloth.material.shear = 3e7;
    const double angle = 0.3;
    cloth.axes.assign(cloth.mesh.number_of_faces(), Vector3d(std::cos(angle), std::sin(angle), 0));
    const BreakableShell sheet({iron, cloth});
    for (const HingeStencil& stencil : sheet.mechanics().hinges) {
        const HingePositions rest = columns(sheet.mechanics().rest, stencil.vertices);
        const Vector3d edge = rest.col(1) - rest.col(0);
        const bool is_iron = &stencil == sheet.mechanics().hinges.data();  // the only hinge of the iron sheet
        const double expected = is_iron
                                    ? hinge_stiffness(iron.material)
                                    : hinge_stiffness(cloth.material, angle - std::atan2(edge.y(), edge.x()));
        EXPECT_NEAR(stencil.stiffness, expected, 1e-12 * expected);
    }
    for (std::size_t f = 0; f < sheet.mechanics().triangles.size(); ++f) {
        const TriangleStencil& triangle = sheet.mechanics().triangles[f];
        const TrianglePositions rest = columns(sheet.mechanics().rest, triangle.vertices);
        const Vector3d edge = rest.col(1) - rest.col(0);
        const Matrix3d expected =
            f < 2 ? membrane_elasticity(iron.material)
                  : membrane_elasticity(cloth.material, angle - std::atan2(edge.y(), edge.x()));
        EXPECT_LT((triangle.membrane.elasticity - expected).norm(), 1e-12 * expected.norm());
    }
}

TEST(BreakableShell, RefusesInadmissibleConstantsAndMissingAxes) {
    SheetInput cloth = input(test::grid(1, 1));
    cloth.material.shear = -1;
    cloth.axes.assign(2, Vector3d::UnitX());
    EXPECT_THROW(BreakableShell({cloth}), Error);
    cloth.material.shear = 1e8;
    EXPECT_NO_THROW(BreakableShell({cloth}));
    cloth.axes.clear();
    EXPECT_THROW(BreakableShell({cloth}), Error);
}

}  // namespace
}  // namespace sherd
