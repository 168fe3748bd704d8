// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/opening_strain.h"

#include <cmath>

namespace sherd {
namespace {

/// A hinge's two faces and the outward normal of its edge in each, in the faces' rest frames.
struct HingeSides {
    std::array<Face, 2> faces;
    std::array<Vector2d, 2> normals;  ///< 1/m: one over the height on the edge
};

HingeSides sides_of(const BreakableSheet& sheet, std::size_t hinge) {
    HingeSides sides;
    const Edge edge = sheet.edge_of_hinge(hinge);
    for (const int side : {0, 1}) {
        const Face face = sheet.mesh().face(sheet.mesh().halfedge(edge, side));
        const TriangleStencil& triangle = sheet.mechanics().triangles[face];
        const Index apex = sheet.mechanics().hinges[hinge].vertices[2 + side];
        int place = 0;
        while (triangle.vertices[place] != apex) ++place;
        sides.faces[side] = face;
        sides.normals[side] = -triangle.membrane.derivatives.row(place).transpose();
    }
    return sides;
}

Eigen::Matrix2d tensor(const Vector3d& green) {
    Eigen::Matrix2d strain;
    strain << green[0], green[2] / 2, green[2] / 2, green[1];
    return strain;
}

}  // namespace

VectorXd hinge_strains(const BreakableSheet& sheet, const Positions& x) {
    const std::vector<HingeStencil>& hinges = sheet.mechanics().hinges;
    VectorXd strains(hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i)
        strains[i] = hinge_strain(hinges[i].rest, hinge_positions(x, hinges[i].vertices));
    return strains;
}

VectorXd opening_strains(const BreakableSheet& sheet, const Positions& x) {
    const Sheet& mechanics = sheet.mechanics();
    const VectorXd bending = hinge_strains(sheet, x);
    std::vector<HingeSides> sides;
    std::vector<Eigen::Matrix2d> curvature(mechanics.triangles.size(), Eigen::Matrix2d::Zero());
    for (std::size_t i = 0; i < mechanics.hinges.size(); ++i) {
        sides.push_back(sides_of(sheet, i));
        const RestHinge& rest = mechanics.hinges[i].rest;
        const double turn = bending[i] * rest.area / rest.edge_length;
        for (const int side : {0, 1}) {
            const Vector2d& normal = sides[i].normals[side];
            curvature[sides[i].faces[side]] += turn / normal.norm() * normal * normal.transpose();
        }
    }
    VectorXd strains(mechanics.hinges.size());
    for (std::size_t i = 0; i < mechanics.hinges.size(); ++i) {
        double stretch = 0, bend = 0;
        for (const int side : {0, 1}) {
            const TriangleStencil& triangle = mechanics.triangles[sides[i].faces[side]];
            const Vector2d across = sides[i].normals[side].normalized();
            const Vector3d green = green_strain(triangle.membrane, triangle_positions(x, triangle.vertices));
            stretch += 0.5 * across.dot(tensor(green) * across);
            bend += 0.5 * across.dot(curvature[sides[i].faces[side]] * across);
        }
        strains[i] = stretch / (0.5 * mechanics.thickness[mechanics.hinges[i].vertices[0]]) + std::abs(bend);
    }
    return strains;
}

}  // namespace sherd
