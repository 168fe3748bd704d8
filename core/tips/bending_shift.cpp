// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/bending_shift.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/material/orthotropy.h"
#include "core/shell/thickness.h"
#include "core/tips/crack_tip.h"
#include "core/tips/fold_changes.h"

namespace sherd {
namespace {

Index number_in(const std::vector<Index>& sorted, Index value) {
    return static_cast<Index>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

/// The sides that a fold joins; for a mirror, its only side.
std::vector<TriangleEdge> sides_of(const CoupledBending& bending, Index fold) {
    const Folds& folds = bending.all_folds();
    if (fold < folds.folds_of_edges()) return {folds.mirror_side(fold)};
    const auto sides = bending.face_curvature().around().sides_of(fold - folds.folds_of_edges());
    return sides ? std::vector<TriangleEdge>(sides->begin(), sides->end()) : std::vector<TriangleEdge>();
}

void add_faces(const Shell& shell, ShellPart& part) {
    for (const Index face : part.faces)
        for (const Index vertex : shell.triangles[face].vertices) part.vertices.push_back(vertex);
    make_unique(part.vertices);
    resize_vertices(part.shell, static_cast<Index>(part.vertices.size()));
    part.shell.rest = shell.rest(Eigen::all, part.vertices);
    part.shell.thickness = shell.thickness(part.vertices);
    part.shell.uneven = shell.uneven;
    for (const Index face : part.faces) {
        part.shell.triangles.push_back(shell.triangles[face]);
        for (Index& vertex : part.shell.triangles.back().vertices) vertex = number_in(part.vertices, vertex);
    }
}

void add_fold(const Shell& shell, const CoupledBending& bending, Index fold, ShellPart& part) {
    const Index of_edges = bending.all_folds().folds_of_edges();
    if (fold < of_edges) {
        auto [face, corner] = bending.all_folds().mirror_side(fold);
        // Any plane that contains the side serves as the mirror's plane.
        part.mirrors.push_back(clamp_hinge(part.shell, {number_in(part.faces, face), corner}, 0));
        return;
    }
    HingeStencil hinge = shell.hinges[shell.edge_hinge[fold - of_edges]];
    for (Index& vertex : hinge.vertices) vertex = number_in(part.vertices, vertex);
    part.shell.edge_hinge.push_back(static_cast<Index>(part.shell.hinges.size()));
    part.shell.hinge_edge.push_back(part.shell.edge_hinge.back());
    part.shell.hinges.push_back(hinge);
}

/// Step of the numerical differences, over the square root of the smallest face's area: the errors of
/// differencing and of round-off are both far below the error of the mesh.
constexpr double difference = 1e-5;

/// Contribution of a face to S, N m, with a row and a column for each of `folds`; nothing if the face depends
/// on other folds. number(fold): number in the shell of the fold of a term; rigidity:
/// CoupledBending::rigidity() of the face.
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

ShellPart shell_part(const Shell& shell, const CoupledBending& bending, std::span<const Index> folds) {
    ShellPart part;
    part.folds.assign(folds.begin(), folds.end());
    make_unique(part.folds);
    for (const Index fold : part.folds)
        for (const TriangleEdge& side : sides_of(bending, fold)) part.faces.push_back(side.triangle);
    make_unique(part.faces);
    add_faces(shell, part);
    for (const Index fold : part.folds) add_fold(shell, bending, fold, part);
    return part;
}

void move_rest(ShellPart& part, const Positions& rest) {
    for (auto& [vertices, membrane] : part.shell.triangles) {
        const TrianglePositions before = columns(part.shell.rest, vertices), after = columns(rest, vertices);
        // Angle by which the side on the frame's first axis turns against the material.
        const Eigen::Matrix<double, 3, 2> axes = frame_axes(before);
        const Vector3d side = after.col(1) - after.col(0);
        const double turn = std::atan2(axes.col(1).dot(side), axes.col(0).dot(side));
        membrane = membrane_triangle(after, turned_elasticity(membrane.elasticity, -turn));
    }
    part.shell.rest = rest;
}

Index TipShift::find(Index vertex) const {
    const auto at = std::ranges::lower_bound(vertices, vertex);
    return at == vertices.end() || *at != vertex ? -1 : static_cast<Index>(at - vertices.begin());
}

TipShift tip_shift(const Shell& shell, const VertexFaces& around, const CrackTip& tip, int rings) {
    TipShift shift{tip.vertex, {}, {}};
    for (int ring = 0; ring <= rings && ring < static_cast<int>(tip.rings.size()); ++ring)
        shift.vertices.insert(shift.vertices.end(), tip.rings[ring].begin(), tip.rings[ring].end());
    std::ranges::sort(shift.vertices);
    for (const Index vertex : shift.vertices)
        shift.by.emplace_back(smallest_turn(tip.normal, rest_normal(shell, around, vertex)) * tip.axes());
    return shift;
}

BendingShift::BendingShift(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                           TipShift moving)
    : shell(shell), bending(bending), shift(std::move(moving)) {
    // The curvature of a face depends on the folds of its patches, and these folds on triangles across them.
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
        // If an advance in one direction makes further triangles join a patch, so that a face depends on
        // other folds, the difference is taken in the other direction alone.
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
        // The mirror image moves along with its triangle, so that the angle at rest does not change.
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
