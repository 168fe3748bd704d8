// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/hinge_measures.h"

#include <cmath>

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

/// Returns the vector whose dot product with a strain (00, 11, 2 * 01) is the component across an edge of
/// normal n.
Vector3d across(const Vector2d& n) {
    return Vector3d(n.x() * n.x(), n.y() * n.y(), n.x() * n.y()) / n.squaredNorm();
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

double HingeMeasures::of(Measure measure, Index hinge) const {
    switch (measure) {
        case Measure::bending:
            return bending[hinge];
        case Measure::stress:
            return stress[hinge];
        default:
            return strain[hinge];
    }
}

HingeMeasures hinge_measures(const BreakableShell& shell, const Positions& x,
                             const std::optional<Eigen::Matrix3Xd>& curvatures,
                             const std::optional<Eigen::Matrix3Xd>& strains,
                             const std::optional<Eigen::Matrix3Xd>& kept) {
    const Shell& mechanics = shell.mechanics();
    std::vector<std::array<TriangleEdge, 2>> sides;
    sides.reserve(mechanics.hinges.size());
    for (std::size_t i = 0; i < mechanics.hinges.size(); ++i) sides.push_back(sides_of(shell, i));
    const VectorXd bending = hinge_strains(shell, x);
    const Eigen::Matrix3Xd green = strains ? *strains : green_strains(mechanics, x);
    const Eigen::Matrix3Xd curvature =
        curvatures ? *curvatures : curvatures_of_hinges(mechanics, sides, bending, AngleShare::equal);

    // Products of the plane-stress elasticity with strain and curvature, N/m and N/m^2, the third component
    // doubled.
    Eigen::Matrix3Xd force(3, green.cols()), moment(3, green.cols());
    for (Eigen::Index face = 0; face < green.cols(); ++face) {
        const Matrix3d& elasticity = mechanics.triangles[static_cast<std::size_t>(face)].membrane.elasticity;
        force.col(face) = elasticity * green.col(face);
        moment.col(face) = elasticity * curvature.col(face);
    }
    force.row(2) *= 2;
    moment.row(2) *= 2;

    HingeMeasures measures;
    measures.bending = bending.cwiseAbs();
    measures.strain = measures.stress = VectorXd::Zero(bending.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const double thickness = mean_thickness(mechanics, mechanics.hinges[i].vertices);
        double stretch = 0, bend = 0, pull = 0, bending_stress = 0;
        for (const auto& [face, corner] : sides[i]) {
            const Vector3d part = across(side_normal(mechanics.triangles[face].membrane, corner));
            stretch += 0.5 * part.dot(green.col(face));
            bend += 0.5 * part.dot(curvature.col(face));
            if (kept) bend += 0.5 * part.dot(kept->col(face));
            pull += 0.5 * part.dot(force.col(face)) / thickness;
            bending_stress += 0.5 * part.dot(moment.col(face)) / 2;
        }
        measures.strain[i] = stretch / (0.5 * thickness) + std::abs(bend);
        measures.stress[i] = pull + std::abs(bending_stress);
    }
    return measures;
}

}  // namespace sherd
