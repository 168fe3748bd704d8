// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/hinge_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bending/hinge_curvature.h"
#include "core/elements/hinge_angles.h"
#include "core/shell/face_fields.h"

namespace sherd {
namespace {

/// The sides of T0 and T1 that a hinge joins, in the order of sides_of_hinges().
std::array<TriangleEdge, 2> sides_of(const BreakableShell& shell, std::size_t hinge) {
    std::array<TriangleEdge, 2> sides;
    const Edge edge = shell.edge_of_hinge(hinge);
    for (const int side : {0, 1}) {
        const Face face = shell.mesh().face(shell.mesh().halfedge(edge, side));
        const std::array<Index, 3>& vertices = shell.mechanics().triangles[face].vertices;
        const Index apex = shell.mechanics().hinges[hinge].vertices[2 + side];
        int corner = 0;
        while (vertices[corner] != apex) ++corner;
        sides[side] = {static_cast<Index>(face), corner};
    }
    return sides;
}

/// Returns the vector whose dot product with a strain (00, 11, 2 * 01) is the strain across an edge whose
/// normal is n.
Vector3d across(const Vector2d& n) {
    return Vector3d(n.x() * n.x(), n.y() * n.y(), n.x() * n.y()) / n.squaredNorm();
}

double hinge_strain_at(const BreakableShell& shell, Index hinge, const Positions& x) {
    const HingeStencil& stencil = shell.mechanics().hinges[hinge];
    double strain = 0;
    find_hinge_angles(
        x, 1, [&](Index) { return stencil.vertices; },
        [&](Index, double angle) { strain = hinge_strain(stencil.rest, angle); });
    return strain;
}

/// Changes of curvature of two faces, [3, 2], 1/m, each from the angles of the face's own hinges, as for
/// hinges that are not coupled.
Eigen::Matrix3Xd own_curvatures(const BreakableShell& shell, const std::array<Index, 2>& faces,
                                const Positions& x) {
    Eigen::Matrix3Xd curvatures = Eigen::Matrix3Xd::Zero(3, 2);
    for (const int i : {0, 1}) {
        std::vector<Index> hinges;  // ascending, as curvatures_of_hinges() sums them
        for (const Halfedge h : shell.mesh().halfedges_around_face(shell.mesh().halfedge(Face(faces[i]))))
            if (const Index hinge = shell.hinge_of_edge(shell.mesh().edge(h)); hinge >= 0)
                hinges.push_back(hinge);
        std::ranges::sort(hinges);
        for (const Index hinge : hinges)
            for (const auto& [face, corner] : sides_of(shell, hinge))
                if (face == faces[i])
                    curvatures.col(i) += curvature_of_hinge(
                        shell.mechanics().hinges[hinge].rest, shell.mechanics().triangles[face].membrane,
                        corner, hinge_strain_at(shell, hinge, x), AngleShare::equal);
    }
    return curvatures;
}

/// State of some faces, a column for each: see hinge_measures() for strain, curvature and plastic curvature.
/// Members `force`, N/m, and `moment`, N/m^2, are the products of the plane-stress elasticity with strain and
/// curvature, with the third component doubled.
struct FaceColumns {
    const Eigen::Matrix3Xd &strain, &curvature;
    const std::optional<Eigen::Matrix3Xd>& plastic;
    Eigen::Matrix3Xd force, moment;

    FaceColumns(const Shell& shell, std::span<const Index> faces, const Eigen::Matrix3Xd& strain,
                const Eigen::Matrix3Xd& curvature, const std::optional<Eigen::Matrix3Xd>& plastic)
        : strain(strain),
          curvature(curvature),
          plastic(plastic),
          force(3, strain.cols()),
          moment(3, strain.cols()) {
        for (Eigen::Index i = 0; i < strain.cols(); ++i) {
            const Matrix3d& elasticity = shell.triangles[faces[i]].membrane.elasticity;
            force.col(i) = elasticity * strain.col(i);
            moment.col(i) = elasticity * curvature.col(i);
        }
        force.row(2) *= 2;
        moment.row(2) *= 2;
    }
};

/// Measures of the hinge that joins two sides. at: columns of the sides' faces in `faces`; bending: 1/m,
/// hinge_strains() of the hinge.
HingeMeasure measure_of(const Shell& shell, const HingeStencil& hinge,
                        const std::array<TriangleEdge, 2>& sides, const std::array<Index, 2>& at,
                        const FaceColumns& faces, double bending) {
    const double thickness = mean_thickness(shell, hinge.vertices);
    double stretch = 0, bend = 0, pull = 0, bending_stress = 0;
    for (const int side : {0, 1}) {
        const auto& [face, corner] = sides[side];
        const Vector3d part = across(side_normal(shell.triangles[face].membrane, corner));
        stretch += 0.5 * part.dot(faces.strain.col(at[side]));
        bend += 0.5 * part.dot(faces.curvature.col(at[side]));
        if (faces.plastic) bend += 0.5 * part.dot(faces.plastic->col(at[side]));
        pull += 0.5 * part.dot(faces.force.col(at[side])) / thickness;
        bending_stress += 0.5 * part.dot(faces.moment.col(at[side])) / 2;
    }
    return {std::abs(bending), stretch / (0.5 * thickness) + std::abs(bend), pull + std::abs(bending_stress)};
}

}  // namespace

VectorXd hinge_strains(const BreakableShell& shell, const Positions& x) {
    const std::vector<HingeStencil>& hinges = shell.mechanics().hinges;
    VectorXd strains(hinges.size());
    find_hinge_angles(
        x, static_cast<Index>(hinges.size()), [&](Index i) { return hinges[i].vertices; },
        [&](Index i, double angle) { strains[i] = hinge_strain(hinges[i].rest, angle); });
    return strains;
}

double HingeMeasure::of(Measure measure) const {
    switch (measure) {
        case Measure::bending:
            return bending;
        case Measure::stress:
            return stress;
        default:
            return strain;
    }
}

HingeMeasures hinge_measures(const BreakableShell& shell, const Positions& x,
                             const std::optional<Eigen::Matrix3Xd>& curvatures,
                             const std::optional<Eigen::Matrix3Xd>& strains,
                             const std::optional<Eigen::Matrix3Xd>& plastic) {
    const Shell& mechanics = shell.mechanics();
    std::vector<std::array<TriangleEdge, 2>> sides;
    sides.reserve(mechanics.hinges.size());
    for (std::size_t i = 0; i < mechanics.hinges.size(); ++i) sides.push_back(sides_of(shell, i));
    const VectorXd bending = hinge_strains(shell, x);
    const Eigen::Matrix3Xd green = strains ? *strains : green_strains(mechanics, x);
    const Eigen::Matrix3Xd curvature =
        curvatures ? *curvatures : curvatures_of_hinges(mechanics, sides, bending, AngleShare::equal);
    const FaceColumns faces(mechanics, numbers_up_to(static_cast<Index>(green.cols())), green, curvature,
                            plastic);

    HingeMeasures measures;
    for (VectorXd HingeMeasures::*member :
         {&HingeMeasures::bending, &HingeMeasures::strain, &HingeMeasures::stress})
        (measures.*member).resize(bending.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto hinge = static_cast<Eigen::Index>(i);
        const HingeMeasure one =
            measure_of(mechanics, mechanics.hinges[i], sides[i], {sides[i][0].triangle, sides[i][1].triangle},
                       faces, bending[hinge]);
        measures.bending[hinge] = one.bending;
        measures.strain[hinge] = one.strain;
        measures.stress[hinge] = one.stress;
    }
    return measures;
}

std::array<Index, 2> faces_of_hinge(const BreakableShell& shell, Index hinge) {
    const std::array<TriangleEdge, 2> sides = sides_of(shell, hinge);
    return {sides[0].triangle, sides[1].triangle};
}

HingeMeasure hinge_measure(const BreakableShell& shell, Index hinge, const Positions& x,
                           const std::optional<Eigen::Matrix3Xd>& curvatures, const Eigen::Matrix3Xd& strains,
                           const std::optional<Eigen::Matrix3Xd>& plastic) {
    const std::array<Index, 2> faces = faces_of_hinge(shell, hinge);
    const Eigen::Matrix3Xd curvature = curvatures ? *curvatures : own_curvatures(shell, faces, x);
    return measure_of(shell.mechanics(), shell.mechanics().hinges[hinge], sides_of(shell, hinge), {0, 1},
                      FaceColumns(shell.mechanics(), faces, strains, curvature, plastic),
                      hinge_strain_at(shell, hinge, x));
}

}  // namespace sherd
