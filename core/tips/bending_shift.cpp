// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/bending_shift.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/shell/thickness.h"
#include "core/tips/fold_changes.h"

namespace sherd {
namespace {

/// Step of the differences over the square root of the smallest face's area: errors of differencing and of
/// round-off are both far below those of the mesh.
constexpr double difference = 1e-5;

/// Contribution of a face to S, by the folds of the shell in this order; nothing if it depends on other
/// folds. number: of a term's fold in the shell. rigidity: CoupledBending::rigidity().
template <class Number>
std::optional<Eigen::MatrixXd> stiffness_of(std::span<const FaceCurvature::Term> terms, Number number,
                                            const Matrix3d& rigidity, const std::vector<Index>& folds) {
    Eigen::Matrix3Xd per_angle(3, static_cast<Eigen::Index>(folds.size()));
    if (terms.size() != folds.size()) return std::nullopt;
    for (const auto& [fold, of_fold] : terms) {
        const auto at = std::ranges::find(folds, number(fold));
        if (at == folds.end()) return std::nullopt;
        per_angle.col(at - folds.begin()) = of_fold;
    }
    return per_angle.transpose() * rigidity * per_angle;
}

Matrix3d rigidity_of(const Shell& shell, Index face) {
    const auto& [vertices, membrane] = shell.triangles[face];
    const double thickness = mean_thickness(shell, vertices);
    return membrane.area * thickness * thickness / 12 * membrane.elasticity;
}

/// Faces with a corner at most `steps` edges away from one of the vertices, by ascending number.
std::vector<Index> faces_near(const Shell& shell, const VertexFaces& around, std::vector<Index> vertices,
                              int steps) {
    std::vector<Index> faces;
    for (int step = 0; step <= steps; ++step) {
        faces.clear();
        for (const Index vertex : vertices)
            faces.insert(faces.end(), around[vertex].begin(), around[vertex].end());
        make_unique(faces);
        vertices.clear();
        for (const Index face : faces)
            vertices.insert(vertices.end(), shell.triangles[face].vertices.begin(),
                            shell.triangles[face].vertices.end());
        make_unique(vertices);
    }
    return faces;
}

/// The rest positions of a part once the tip has advanced by `length` m along one of its axes.
Positions advanced(const ShellPart& part, const TipShift& shift, int axis, double length) {
    Positions rest = part.shell.rest;
    for (std::size_t v = 0; v < part.vertices.size(); ++v)
        if (const Index moved = shift.find(part.vertices[v]); moved >= 0)
            rest.col(static_cast<Eigen::Index>(v)) += length * shift.by[moved].col(axis);
    return rest;
}

}  // namespace

BendingShift::BendingShift(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                           TipShift moving)
    : shell(shell), bending(bending), shift(std::move(moving)) {
    // The curvature of a face depends on the folds of its patches, and these on the triangles across.
    for (const Index face : faces_near(shell, around, shift.vertices, 3)) add_if_affected(face);
    for (const AffectedFace& face : affected) folds.insert(folds.end(), face.folds.begin(), face.folds.end());
    make_unique(folds);
    std::ranges::copy_if(folds, std::back_inserter(moved), [this](Index fold) { return moves(fold); });
    for (int axis = 0; axis < 2; ++axis) differentiate(axis);
}

bool BendingShift::moves(Index fold) const {
    const std::array<Index, 4> vertices = bending.all_folds().vertices(fold);
    return std::ranges::any_of(vertices, [this](Index vertex) { return shift.find(vertex) >= 0; });
}

void BendingShift::add_if_affected(Index face) {
    std::vector<Index> of_face;
    for (const auto& [fold, per_angle] : bending.face_curvature().terms(face)) of_face.push_back(fold);
    if (std::ranges::any_of(of_face, [this](Index fold) { return moves(fold); }))
        affected.push_back({face, std::move(of_face), {}});
}

std::vector<std::optional<Eigen::MatrixXd>> BendingShift::advanced_stiffness(ShellPart part, int axis,
                                                                             double length) const {
    move_rest(part, advanced(part, shift, axis, length));
    const Folds of_part(part.shell, part.mirrors);
    const FaceCurvature curvature(part.shell, of_part);
    std::vector<std::optional<Eigen::MatrixXd>> of_faces;
    for (const AffectedFace& face : affected) {
        const auto at = std::ranges::lower_bound(part.faces, face.face) - part.faces.begin();
        of_faces.push_back(stiffness_of(
            curvature.terms(static_cast<std::size_t>(at)), [&](Index fold) { return part.folds[fold]; },
            rigidity_of(part.shell, static_cast<Index>(at)), face.folds));
    }
    return of_faces;
}

void BendingShift::differentiate(int axis) {
    const ShellPart part = shell_part(shell, bending, folds);
    double length = std::numeric_limits<double>::infinity();
    for (const auto& [vertices, membrane] : part.shell.triangles)
        length = std::min(length, std::sqrt(membrane.area));
    length *= difference;
    const auto ahead = advanced_stiffness(part, axis, length),
               behind = advanced_stiffness(part, axis, -length);
    for (std::size_t i = 0; i < affected.size(); ++i) {
        auto& [face, of_face, stiffening] = affected[i];
        const auto here = stiffness_of(bending.face_curvature().terms(face), std::identity(),
                                       bending.rigidity(face), of_face);
        // Where the next triangles are about to join a patch, the difference is taken on the side where they
        // do not.
        const auto &to = ahead[i] ? ahead[i] : here, &from = behind[i] ? behind[i] : here;
        stiffening[axis] = (*to - *from) / (ahead[i] && behind[i] ? 2 * length : length);
    }
}

Vector2d BendingShift::force(const Positions& x, const Matrix3d& turn) const {
    const VectorXd changes = changes_of(bending, x, folds);
    VectorXd moments = VectorXd::Zero(changes.size());
    Vector2d sum = Vector2d::Zero();
    for (const auto& [face, of_face, stiffening] : affected) {
        const Vector3d moment = bending.rigidity(face) * bending.face_curvature().of(face, changes);
        for (const auto& [fold, per_angle] : bending.face_curvature().terms(face))
            moments[fold] += per_angle.dot(moment);
        const VectorXd local = changes(of_face);
        for (int axis = 0; axis < 2; ++axis) sum[axis] -= 0.5 * local.dot(stiffening[axis] * local);
    }
    return sum - turned_folds(x, turn, moments);
}

Vector2d BendingShift::turned_folds(const Positions& x, const Matrix3d& turn, const VectorXd& moments) const {
    const Folds& all = bending.all_folds();
    Vector2d sum = Vector2d::Zero();
    for (const Index fold : moved) {
        // The mirror image moves along, so that at rest the angle stays zero.
        const bool mirrored = fold < all.folds_of_edges();
        const std::array<Index, 4> vertices = all.vertices(fold);
        const HingePositions now = mirrored ? all.slopes(x, std::span(&fold, 1))[fold].gradient
                                            : DihedralAngle(columns(x, vertices)).gradient();
        const HingePositions before = mirrored ? HingePositions(HingePositions::Zero())
                                               : DihedralAngle(columns(shell.rest, vertices)).gradient();
        for (int v = 0; v < 4; ++v)
            if (const Index by = shift.find(vertices[v]); by >= 0)
                sum += moments[fold] * shift.by[by].transpose() *
                       (turn.transpose() * now.col(v) - before.col(v));
    }
    return sum;
}

}  // namespace sherd
