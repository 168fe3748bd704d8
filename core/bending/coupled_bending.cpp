// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_bending.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/shell/inheritance.h"
#include "core/shell/thickness.h"

namespace sherd {
CoupledBending::CoupledBending(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
    : shell(shell),
      folds(shell, mirrors),
      curvature(shell, folds),
      present(folds.present()),
      start(folds.rest_angles()) {}

void CoupledBending::invalidate_reach() {
    reach.clear();
    reach_is_valid = false;
}

void CoupledBending::invalidate_reach(const ShellChange& change, std::span<const Index> changed) {
    reach_is_valid = false;
    if (reach.empty()) return;
    reach.resize(shell.triangles.size());
    const auto invalidate = [&](std::size_t face) {
        reach[face].vertices.clear();
        reach[face].places.clear();
    };
    for (const Index face : changed) invalidate(face);
    std::vector<char> was_split(shell.position.cols(), 0);
    for (const IndexWithParents& inserted : change.vertices)
        for (const auto& [vertex, weight] : inserted.parents) was_split[vertex] = 1;
    for (std::size_t face = 0; face < reach.size(); ++face)
        if (std::ranges::any_of(reach[face].vertices, [&](Index v) { return was_split[v] != 0; }))
            invalidate(face);
}

const std::vector<CoupledBending::Reach>& CoupledBending::reach_of_faces() const {
    if (reach_is_valid) return reach;
    reach_is_valid = true;
    reach.resize(shell.triangles.size());
    for (std::size_t face = 0; face < reach.size(); ++face) {
        auto& [vertices, places] = reach[face];
        if (!vertices.empty()) continue;
        for (const auto& [fold, per_angle] : curvature.terms(face)) folds.collect(fold, vertices);
        std::ranges::sort(vertices);
        for (const auto& [fold, per_angle] : curvature.terms(face)) {
            std::array<Index, 4> place = folds.vertices(fold);
            for (Index& vertex : place)
                if (vertex >= 0)
                    vertex = static_cast<Index>(std::ranges::find(vertices, vertex) - vertices.begin());
            places.push_back(place);
        }
    }
    return reach;
}

void CoupledBending::start_from(const Positions& x, double factor) {
    start = folds.angles(x);
    scale = factor;
}

void CoupledBending::set_yield(std::vector<double> yield_of_sheet) {
    yields = std::move(yield_of_sheet);
    plastic.resize(shell.triangles.size());
    store_plastic_curvature(shell.position);
}

YieldingSection CoupledBending::section(Index face) const {
    const auto& [vertices, membrane] = shell.triangles[face];
    const double t = mean_thickness(shell, vertices);
    return {t * t / 12 * membrane.elasticity, yields[shell.face_sheet[face]] * t * t / 6};
}

double CoupledBending::dissipated_by_yielding(const Positions& x) const {
    if (yields.empty()) return 0;
    const VectorXd all = changes(x, present);
    double sum = 0;
    for (Index face = 0; face < faces(); ++face)
        if (yields_at(face))
            sum += shell.triangles[face].membrane.area * yielded(face, curvature.of(face, all)).taken;
    return sum;
}

void CoupledBending::store_plastic_curvature(const Positions& x) {
    if (yields.empty()) return;
    const VectorXd all = changes(x, present);
    for (Index face = 0; face < faces(); ++face)
        if (yields_at(face)) plastic[face] = yielded(face, curvature.of(face, all)).plastic;
}

Matrix3d CoupledBending::stiffness(Index face, const VectorXd& changes) const {
    if (!yields_at(face)) return rigidity(face);
    const YieldingSection here = section(face);
    const YieldingSection::State state = here.at(curvature.of(face, changes), plastic[face]);
    return shell.triangles[face].membrane.area * here.tangent(state, plastic[face]);
}

void CoupledBending::topology_changed(const ShellChange& change, const StepContext&) {
    folds.follow(change);
    const std::vector<Index> changed = curvature.follow(change);
    folds.extend(change, start);
    if (!yields.empty()) append(plastic, change.faces, Inheritance::first, PlasticBend{});
    present = folds.present();
    invalidate_reach(change, changed);
}

double CoupledBending::rigidity_factor(Index face) const {
    const auto& [vertices, membrane] = shell.triangles[face];
    const double thickness = mean_thickness(shell, vertices);
    return scale * membrane.area * thickness * thickness / 12;
}

VectorXd CoupledBending::changes_from(const VectorXd& angles) const {
    return (angles - start).unaryExpr([](double change) {
        return std::abs(change) <= std::numbers::pi ? change : std::remainder(change, 2 * std::numbers::pi);
    });
}

Eigen::Matrix3Xd CoupledBending::curvatures(const Positions& x) const {
    return curvatures_at(numbers_up_to(faces()), changes(x));
}

Eigen::Matrix3Xd CoupledBending::curvatures_at(std::span<const Index> some, const VectorXd& changes) const {
    Eigen::Matrix3Xd of_faces(3, some.size());
    for (Index i = 0; i < static_cast<Index>(of_faces.cols()); ++i)
        of_faces.col(i) = curvature.of(some[i], changes);
    if (!yields.empty()) of_faces -= kept_at(some, changes);
    return of_faces;
}

Eigen::Matrix3Xd CoupledBending::plastic_curvatures(const Positions& x) const {
    return kept_at(numbers_up_to(faces()), changes(x));
}

Eigen::Matrix3Xd CoupledBending::kept_at(std::span<const Index> some, const VectorXd& changes) const {
    Eigen::Matrix3Xd of_faces = Eigen::Matrix3Xd::Zero(3, some.size());
    for (Index i = 0; i < static_cast<Index>(of_faces.cols()); ++i)
        if (const Index face = some[i]; yields_at(face))
            of_faces.col(i) = yielded(face, curvature.of(face, changes)).plastic.curvature;
    return of_faces;
}

std::vector<MirrorGradient> CoupledBending::mirror_gradients(const Positions& x) const {
    return folds.mirror_gradients(x, moments(changes(x, present)));
}

/// The derivative of the energy by the angles of all folds, N m: S dtheta.
VectorXd CoupledBending::moments(const VectorXd& changes) const {
    VectorXd all = VectorXd::Zero(changes.size());
    for (Index face = 0; face < faces(); ++face) {
        const Vector3d of_face = moment(face, curvature.of(face, changes));
        for (const auto& [fold, per_angle] : curvature.terms(face)) all[fold] += per_angle.dot(of_face);
    }
    return all;
}

double CoupledBending::value(const Positions& x) const {
    const VectorXd all = changes(x, present);
    double sum = 0;
    for (Index face = 0; face < faces(); ++face) {
        const Vector3d bent = curvature.of(face, all);
        if (yields_at(face)) {
            const YieldingSection::State state = yielded(face, bent);
            sum += shell.triangles[face].membrane.area * (state.stored + state.taken);
        } else {
            sum += 0.5 * bent.dot(moment(face, bent));
        }
    }
    return sum;
}

double CoupledBending::round_off() const {
    double sum = 0;
    for (Index face = 0; face < faces(); ++face)
        for (const auto& [fold, per_angle] : curvature.terms(face))
            sum += per_angle.dot(rigidity(face) * per_angle);
    return 4 * std::numeric_limits<double>::epsilon() * sum;
}

void CoupledBending::add_gradient(const Positions& x, Positions& gradient) const {
    folds.find_slopes(x, present, slopes);
    folds.add_gradient(slopes, moments(changes_from(folds.angles(slopes, present))), gradient, present);
}

void CoupledBending::find_slopes(Index face, const std::vector<Folds::Slope>& of_folds,
                                 const VectorXd& changes, BlockMatrix::Columns::Rows& of_face) const {
    const auto& [vertices, places] = reach_of_faces()[face];
    of_face.setZero(3, 3 * static_cast<Eigen::Index>(vertices.size()));
    auto place = places.begin();
    for (const auto& [fold, per_angle] : curvature.terms(face)) {
        const HingePositions& gradient = of_folds[fold].gradient;
        for (int v = 0; v < 4; ++v)
            if ((*place)[v] >= 0)
                of_face.middleCols<3>(3 * (*place)[v]) += per_angle * gradient.col(v).transpose();
        ++place;
    }
    const Matrix3d root = stiffness(face, changes).llt().matrixU();
    of_face = (root * of_face).eval();
}

std::vector<Index> CoupledBending::present_in(const BlockMatrix& hessian) const {
    std::vector<Index> some = present;
    if (hessian.is_part())
        std::erase_if(some, [&](Index fold) { return !hessian.has_all(folds.vertices(fold)); });
    return some;
}

void CoupledBending::add_hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) const {
    const std::vector<Index> some = present_in(hessian);
    folds.find_slopes(x, some, slopes, hessian.shared_among());
    const VectorXd all = yields.empty() ? VectorXd() : changes_from(folds.angles(slopes, some));
    const std::vector<Reach>& reached = reach_of_faces();
    using Rows = BlockMatrix::Columns::Rows;
    hessian.add_elements<Rows>(
        reached.size(),
        [&](std::size_t i, Rows& of_face) {
            if (!hessian.has_all(reached[i].vertices)) return false;
            find_slopes(static_cast<Index>(i), slopes, all, of_face);
            return true;
        },
        [&](BlockMatrix::Columns& columns, std::size_t i, const Rows& of_face) {
            columns.add_square(reached[i].vertices, of_face);
        });
    // Adds the contribution of the second derivatives of the angles.
    if (kind == Curvature::exact) folds.add_hessian(x, moments(changes(x, some)), hessian, some);
}

void CoupledBending::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const auto& [vertices, places] : reach_of_faces())
        add_pairs(pairs, std::span<const Index>(vertices));
}

void CoupledBending::add_pattern_among(const std::vector<char>& among,
                                       std::vector<std::pair<Index, Index>>& pairs) const {
    for (const auto& [vertices, places] : reach_of_faces())
        if (std::ranges::all_of(vertices, [&](Index v) { return among[v] != 0; }))
            add_pairs(pairs, std::span<const Index>(vertices));
}

}  // namespace sherd
