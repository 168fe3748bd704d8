// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/hinge_measures.h"

#include <cmath>

namespace sherd {
namespace {

/// A hinge's two faces and the outward normal of its edge in each, in the faces' rest frames.
struct HingeSides {
    std::array<Face, 2> faces;
    std::array<Vector2d, 2> normals;  ///< 1/m: of length one over the height of the face on the edge
};

/// Green strain of a face and its change of curvature, as (00, 11, 2 * 01) in the face's rest frame.
struct FaceStrain {
    Vector3d green = Vector3d::Zero();
    Vector3d curvature = Vector3d::Zero();  ///< 1/m
};

HingeSides sides_of(const BreakableShell& shell, std::size_t hinge) {
    HingeSides sides;
    const Edge edge = shell.edge_of_hinge(hinge);
    for (const int side : {0, 1}) {
        const Face face = shell.mesh().face(shell.mesh().halfedge(edge, side));
        const TriangleStencil& triangle = shell.mechanics().triangles[face];
        const Index apex = shell.mechanics().hinges[hinge].vertices[2 + side];
        int place = 0;
        while (triangle.vertices[place] != apex) ++place;
        sides.faces[side] = face;
        sides.normals[side] = -triangle.membrane.derivatives.row(place).transpose();
    }
    return sides;
}

/// The dot product with a strain (00, 11, 2 * 01) is its component across an edge of unit normal n.
Vector3d across(const Vector2d& n) {
    return {n.x() * n.x(), n.y() * n.y(), n.x() * n.y()};
}

/// Curvature, 1/m, that a hinge adds to a face. turn: change of its angle, rad; normal: see HingeSides.
Vector3d curvature_of(double turn, const Vector2d& normal) {
    const Vector3d part = turn / normal.norm() * across(normal);
    return {part[0], part[1], 2 * part[2]};
}

std::vector<FaceStrain> face_strains(const Shell& mechanics, const std::vector<HingeSides>& sides,
                                     const VectorXd& bending, const Positions& x,
                                     const std::optional<Eigen::Matrix3Xd>& curvatures,
                                     const std::optional<Eigen::Matrix3Xd>& stretches) {
    std::vector<FaceStrain> strains(mechanics.triangles.size());
    for (std::size_t f = 0; f < strains.size(); ++f) {
        const TriangleStencil& triangle = mechanics.triangles[f];
        strains[f].green = stretches ? Vector3d(stretches->col(static_cast<Eigen::Index>(f)))
                                     : green_strain(triangle.membrane, columns(x, triangle.vertices));
        if (curvatures) strains[f].curvature = curvatures->col(static_cast<Eigen::Index>(f));
    }
    if (curvatures) return strains;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const RestHinge& rest = mechanics.hinges[i].rest;
        const double turn = bending[i] * rest.area / rest.edge_length;
        for (const int side : {0, 1})
            strains[sides[i].faces[side]].curvature += curvature_of(turn, sides[i].normals[side]);
    }
    return strains;
}

}  // namespace

VectorXd hinge_strains(const BreakableShell& shell, const Positions& x) {
    const std::vector<HingeStencil>& hinges = shell.mechanics().hinges;
    VectorXd strains(hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i)
        strains[i] = hinge_strain(hinges[i].rest, columns(x, hinges[i].vertices));
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
                             const std::optional<Eigen::Matrix3Xd>& stretches) {
    const Shell& mechanics = shell.mechanics();
    std::vector<HingeSides> sides;
    for (std::size_t i = 0; i < mechanics.hinges.size(); ++i) sides.push_back(sides_of(shell, i));
    const VectorXd bending = hinge_strains(shell, x);
    const std::vector<FaceStrain> faces = face_strains(mechanics, sides, bending, x, curvatures, stretches);

    HingeMeasures measures;
    measures.bending = bending.cwiseAbs();
    measures.strain = measures.stress = VectorXd::Zero(bending.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const double thickness = mechanics.thickness[mechanics.hinges[i].vertices[0]];
        double stretch = 0, bend = 0, pull = 0, bending_stress = 0;
        for (const int side : {0, 1}) {
            const FaceStrain& face = faces[sides[i].faces[side]];
            const Matrix3d& elasticity = mechanics.triangles[sides[i].faces[side]].membrane.elasticity;
            const Vector3d part = across(sides[i].normals[side].normalized());
            const Vector3d stiff = elasticity.transpose() * Vector3d(part[0], part[1], 2 * part[2]);
            stretch += 0.5 * part.dot(face.green);
            bend += 0.5 * part.dot(face.curvature);
            pull += 0.5 * stiff.dot(face.green) / thickness;
            bending_stress += 0.5 * stiff.dot(face.curvature) / 2;
        }
        measures.strain[i] = stretch / (0.5 * thickness) + std::abs(bend);
        measures.stress[i] = pull + std::abs(bending_stress);
    }
    return measures;
}

}  // namespace sherd
