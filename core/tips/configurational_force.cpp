// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/configurational_force.h"

#include <algorithm>
#include <stdexcept>

namespace sherd {
namespace {

/// Shares of the exact force that result if the tip moves without rings, on meshes of all sizes: the elements
/// near the tip are too stiff.
constexpr double membrane_of_tip = 0.91, bending_of_tip = 0.96;

}  // namespace

Vector2d ConfigurationalForce::corrected() const {
    if (rings > 0) return sum();
    return membrane / membrane_of_tip + bending / bending_of_tip + loads;
}

TipForce::TipForce(const Shell& shell, const VertexFaces& around, const TipEnergies& energies,
                   const CrackTip& tip, int most_rings)
    : shell(shell),
      around(around),
      shift(tip_shift(shell, around, tip, most_rings)),
      faces(faces_around(around, tip, most_rings)),
      rings(std::min(most_rings, static_cast<int>(tip.rings.size()) - 1)) {
    if (energies.membrane != MembraneModel::constant_strain)
        throw std::invalid_argument(
            "the force on a crack tip is implemented for membranes of constant strain only");
    for (int side = 0; side < 2; ++side) {
        crack_faces[side] = {tip.vertex};
        crack_faces[side].insert(crack_faces[side].end(), tip.crack_faces[side].begin(),
                                 tip.crack_faces[side].end());
    }
    if (energies.bending != nullptr) bending.emplace(shell, around, *energies.bending, shift);
}

ConfigurationalForce TipForce::at(const Positions& x, const TipLoads& loads) const {
    const Matrix3d turn = rotation_at(shell, around, shift.tip, x);
    ConfigurationalForce force;
    force.rings = rings;
    force.membrane = of_membrane(x, turn);
    if (bending) force.bending = bending->force(x, turn);
    if (loads.spread.cols() > 0) force.loads += of_spread(x, loads.spread, turn);
    if (loads.on_crack_faces.cols() > 0) force.loads += of_crack_faces(x, loads.on_crack_faces, turn);
    return force;
}

Vector2d TipForce::of_membrane(const Positions& x, const Matrix3d& turn) const {
    Vector2d sum = Vector2d::Zero();
    for (const Index face : faces) {
        const auto& [vertices, membrane] = shell.triangles[face];
        const TrianglePositions now = columns(x, vertices), force = gradient(membrane, now);
        const TrianglePositions by_rest =
            frame_axes(columns(shell.rest, vertices)) * rest_gradient(membrane, now);
        for (int corner = 0; corner < 3; ++corner)
            if (const Index moved = shift.find(vertices[corner]); moved >= 0)
                sum -= shift.by[moved].transpose() *
                       (by_rest.col(corner) + turn.transpose() * force.col(corner));
    }
    return sum;
}

Vector2d TipForce::of_spread(const Positions& x, const Positions& forces, const Matrix3d& turn) const {
    Vector2d sum = Vector2d::Zero();
    for (std::size_t i = 0; i < shift.vertices.size(); ++i) {
        const Index vertex = shift.vertices[i];
        if (vertex == shift.tip) continue;
        Matrix3d stretched = Matrix3d::Zero();
        double area = 0;
        for (const Index face : around[vertex]) {
            const auto& [vertices, membrane] = shell.triangles[face];
            const Eigen::Matrix<double, 3, 2> axes = frame_axes(columns(shell.rest, vertices));
            stretched += membrane.area *
                         (deformation_gradient(membrane, columns(x, vertices)) - turn * axes) *
                         axes.transpose();
            area += membrane.area;
        }
        sum -= shift.by[i].transpose() * (stretched.transpose() / area) * forces.col(vertex);
    }
    return sum;
}

// Contribution of the work of tractions on the crack faces. The traction is taken as constant along the side
// next to the tip, and beyond it follows from the forces on vertices. The force on the tip does not show the
// traction, since the contributions of the two crack faces to it cancel.
Vector2d TipForce::of_crack_faces(const Positions& x, const Positions& forces, const Matrix3d& turn) const {
    Vector2d sum = Vector2d::Zero();
    for (const std::vector<Index>& crack_face : crack_faces)
        for (std::size_t i = 0; i + 1 < crack_face.size(); ++i) {
            const Index moved = shift.find(crack_face[i]);
            if (moved < 0) break;
            const Index ahead = crack_face[i == 0 ? 0 : i - 1], behind = crack_face[i + 1];
            const Vector3d rest = shell.rest.col(ahead) - shell.rest.col(behind);
            const Vector3d stretched = Vector3d(x.col(ahead) - x.col(behind)) - turn * rest;
            Vector3d force = forces.col(crack_face[i]);
            if (i == 0) {
                const double first = rest.norm();
                const double both =
                    crack_face.size() < 3
                        ? 2 * first
                        : first + (shell.rest.col(crack_face[1]) - shell.rest.col(crack_face[2])).norm();
                force = first / both * forces.col(crack_face[1]);
            }
            sum -= force.dot(stretched) / rest.squaredNorm() * shift.by[moved].transpose() * rest;
        }
    return sum;
}

}  // namespace sherd
