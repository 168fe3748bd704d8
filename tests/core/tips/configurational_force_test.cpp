// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/configurational_force.h"

#include <gtest/gtest.h>

#include "core/membrane/membrane_energy.h"
#include "core/tips/crack_tip.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd::test {
namespace {

/// Patch of uneven_patch() that is slit along its middle from the side x = 0, and the tip of the slit.
struct SlitPatch {
    Shell shell;
    std::vector<char> foreign;  ///< [V] flags of the outer boundary
    CrackTip tip;
};

/// edges: number of edges along the slit; turn: rotation of the patch's rest shape.
SlitPatch slit_patch(const Shell& whole, int edges, const Material& material = patch_material,
                     const Matrix3d& turn = Matrix3d::Identity()) {
    constexpr int middle = patch_across / 2;
    const auto row_of = [](Index vertex) { return vertex % patch_across; };
    Positions rest(3, whole.rest.cols() + edges);
    rest.leftCols(whole.rest.cols()) = whole.rest;
    std::vector<std::array<Index, 3>> triangles;
    for (const TriangleStencil& triangle : whole.triangles) {
        triangles.push_back(triangle.vertices);
        if (std::ranges::none_of(triangle.vertices, [&](Index v) { return row_of(v) > middle; })) continue;
        for (Index& vertex : triangles.back())
            if (row_of(vertex) == middle && vertex < edges * patch_across) {
                const Index column = vertex / patch_across;
                vertex = static_cast<Index>(whole.rest.cols()) + column;
                rest.col(vertex) = whole.rest.col(column * patch_across + middle);
            }
    }
    SlitPatch patch{small_sheet(turn * rest, triangles, material), {}, {}};
    for (Index v = 0; v < rest.cols(); ++v) {
        const bool inner = v >= patch_across && v < (patch_along - 1) * patch_across && row_of(v) > 0 &&
                           row_of(v) + 1 < patch_across;
        const bool crack_face = v > whole.rest.cols();
        patch.foreign.push_back(!inner && !crack_face);
    }
    patch.tip =
        crack_tip(patch.shell, VertexFaces(patch.shell), edges * patch_across + middle, patch.foreign);
    return patch;
}

/// Positions with large bending, stretch and rotation.
Positions bent_and_turned(const Shell& shell, unsigned seed) {
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) {
        const Vector3d at = shell.rest.col(v);
        x.col(v) += Vector3d(0.05 * at.x() * at.y(), 0.04 * at.x() - 0.03 * at.y() * at.y(),
                             0.3 * at.x() * at.x() - 0.2 * at.x() * at.y());
    }
    Random random(seed);
    for (double& coordinate : x.reshaped()) coordinate += random.uniform(-0.01, 0.01);
    return (random.rotation() * x).colwise() + random.matrix<Vector3d>(1);
}

}  // namespace
}  // namespace sherd::test

namespace sherd {
namespace {

const Material oak_of_tips{1000, 0.05, 12e4, 0.3, 3e4, 2e4};

test::SlitPatch flat_slit(int edges = 3, const Material& material = test::patch_material) {
    return test::slit_patch(test::flat_patch(), edges, material);
}

test::SlitPatch curved_slit(int edges = 3, const Material& material = test::patch_material) {
    return test::slit_patch(test::curved_patch(), edges, material);
}

/// Shell whose rest shape is moved by `length` (m) times `shift` along an axis (0 or 1). The elasticity
/// stays with the sheet.
Shell with_advanced_tip(const Shell& shell, const TipShift& shift, int axis, double length) {
    Shell there = shell;
    for (std::size_t i = 0; i < shift.vertices.size(); ++i)
        there.rest.col(shift.vertices[i]) += length * shift.by[i].col(axis);
    for (auto& [vertices, membrane] : there.triangles) {
        const TrianglePositions before = columns(shell.rest, vertices), after = columns(there.rest, vertices);
        const Eigen::Matrix<double, 3, 2> axes = frame_axes(before);
        const Vector3d side = after.col(1) - after.col(0);
        const double turn = std::atan2(axes.col(1).dot(side), axes.col(0).dot(side));
        membrane = membrane_triangle(after, turned_elasticity(membrane.elasticity, -turn));
    }
    for (HingeStencil& hinge : there.hinges) hinge = hinge_stencil(there, hinge.vertices, hinge.stiffness);
    return there;
}

/// Minus the derivatives of membrane and bending energy by the tip's place, from shells that are rebuilt at
/// shifted rest shapes.
ConfigurationalForce differenced(const test::SlitPatch& patch, const Positions& x, int rings,
                                 const std::vector<MirrorHinge>& mirrors) {
    const VertexFaces around(patch.shell);
    const TipShift shift = tip_shift(patch.shell, around, patch.tip, rings);
    const Matrix3d turn = rotation_at(patch.shell, around, patch.tip.vertex, x);
    ConfigurationalForce force;
    constexpr double length = 1e-5;
    for (int axis = 0; axis < 2; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const Shell there = with_advanced_tip(patch.shell, shift, axis, sign * length);
            Positions moved = x;
            for (std::size_t i = 0; i < shift.vertices.size(); ++i)
                moved.col(shift.vertices[i]) += sign * length * turn * shift.by[i].col(axis);
            force.membrane[axis] -= sign * MembraneEnergy(there.triangles).value(moved) / (2 * length);
            force.bending[axis] -= sign * CoupledBending(there, mirrors).value(moved) / (2 * length);
        }
    return force;
}

void expect_as_differenced(const test::SlitPatch& patch, const std::vector<MirrorHinge>& mirrors = {}) {
    const VertexFaces around(patch.shell);
    const CoupledBending bending(patch.shell, mirrors);
    for (const int rings : {0, 1}) {
        const Positions x = test::bent_and_turned(patch.shell, 1);
        const ConfigurationalForce force = TipForce(patch.shell, around, {&bending}, patch.tip, rings).at(x),
                                   expected = differenced(patch, x, rings, mirrors);
        EXPECT_EQ(force.rings, rings);
        EXPECT_LT((force.membrane - expected.membrane).norm(), 1e-6 * expected.membrane.norm());
        EXPECT_LT((force.bending - expected.bending).norm(), 1e-5 * expected.bending.norm());
    }
}

// If a term were missing, of the faces' areas, their curvatures or the angles, stress intensities would be
// wrong. The positions are far from any equilibrium.
TEST(ConfigurationalForce, IsTheDerivativeOfTheEnergyByTheRestShape) {
    expect_as_differenced(flat_slit());
    expect_as_differenced(curved_slit());
}

// The elasticity of wood must stay with the sheet when its vertices move.
TEST(ConfigurationalForce, IsTheDerivativeForOrthotropicSheetsToo) {
    expect_as_differenced(flat_slit(3, oak_of_tips));
    expect_as_differenced(curved_slit(3, oak_of_tips));
}

// The rings include faces at a clamp and at a symmetry plane, whose mirror images must count.
TEST(ConfigurationalForce, IsTheDerivativeBesideMirrorsToo) {
    const test::SlitPatch patch = flat_slit(4);
    std::vector<char> wall(patch.shell.rest.cols()), plane(patch.shell.rest.cols());
    for (Index v = 0; v < patch.shell.rest.cols(); ++v) {
        wall[v] = patch.shell.rest(0, v) > 1.2 - 1e-9;
        plane[v] = patch.shell.rest(1, v) < 1e-9;
    }
    std::vector<MirrorHinge> mirrors;
    for (const TriangleEdge& side : boundary_triangle_edges(patch.shell, wall))
        mirrors.push_back(clamp_hinge(patch.shell, side, 1));
    for (const TriangleEdge& side : boundary_triangle_edges(patch.shell, plane))
        mirrors.push_back(symmetry_hinge(patch.shell, side, Vector3d::UnitY(), 1));
    ASSERT_EQ(mirrors.size(), 10U);
    expect_as_differenced(patch, mirrors);
}

// The energy of arcs has other derivatives: a wrong value would not be noticed.
TEST(ConfigurationalForce, IsRefusedForArcs) {
    const test::SlitPatch patch = flat_slit();
    const VertexFaces around(patch.shell);
    EXPECT_THROW(TipForce(patch.shell, around, {nullptr, MembraneModel::arc}, patch.tip),
                 std::invalid_argument);
}

// The force that drives a crack must not depend on a fragment's motion, nor on the place of the rest shape.
TEST(ConfigurationalForce, DoesNotChangeWithRigidMotionOfEitherShape) {
    test::Random random(2);
    const Matrix3d turn = random.rotation();
    const test::SlitPatch patch = curved_slit(),
                          turned = test::slit_patch(test::curved_patch(), 3, test::patch_material, turn);
    const VertexFaces around(patch.shell);
    const CoupledBending bending(patch.shell, {}), bending_turned(turned.shell, {});
    const Positions x = test::bent_and_turned(patch.shell, 3);
    const Positions moved = (random.rotation() * x).colwise() + random.matrix<Vector3d>(2);
    const TipForce here(patch.shell, around, {&bending}, patch.tip),
        there(turned.shell, around, {&bending_turned}, turned.tip);
    const ConfigurationalForce expected = here.at(x);
    EXPECT_LT((turned.tip.direction - turn * patch.tip.direction).norm(), 1e-12);
    for (const ConfigurationalForce& force : {here.at(moved), there.at(x), there.at(moved)}) {
        EXPECT_LT((force.membrane - expected.membrane).norm(), 1e-9 * expected.membrane.norm());
        EXPECT_LT((force.bending - expected.bending).norm(), 1e-5 * expected.bending.norm());
    }
    EXPECT_LT(here.at(turn * patch.shell.rest).sum().norm(), 1e-9 * expected.sum().norm());
}

// Rings that reach another tip, or the outer boundary, give wrong values.
TEST(CrackTip, RingsEndBeforeForeignVertices) {
    for (const auto& [edges, rings] : {std::pair(1, 1), {2, 2}, {3, 2}, {5, 1}}) {
        const test::SlitPatch patch = flat_slit(edges);
        EXPECT_EQ(patch.tip.rings.size(), static_cast<std::size_t>(rings)) << edges;
        for (const std::vector<Index>& ring : patch.tip.rings)
            for (const Index vertex : ring) EXPECT_FALSE(patch.foreign[vertex]);
        EXPECT_NEAR(patch.tip.direction.x(), 1, 0.1) << "away from the slit";
    }
}

// Both crack faces belong to the first ring.
TEST(CrackTip, FirstRingHasBothCrackFaces) {
    const test::SlitPatch patch = flat_slit();
    int behind = 0;
    for (const Index vertex : patch.tip.rings[1])
        behind += patch.shell.rest.col(vertex) == patch.shell.rest.col(2 * test::patch_across + 2);
    EXPECT_EQ(behind, 2);
    EXPECT_THROW(crack_tip(patch.shell, VertexFaces(patch.shell), 4 * test::patch_across + 2, patch.foreign),
                 std::invalid_argument);
}

}  // namespace
}  // namespace sherd
