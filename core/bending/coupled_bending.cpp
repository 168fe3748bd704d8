// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_bending.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sherd {
namespace {

/// How the curvature of a face changes with the position of a vertex, 1/m^2.
struct VertexCurvature {
    Index vertex;
    Matrix3d slope;
};

}  // namespace

CoupledBending::CoupledBending(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
    : shell(shell), folds(shell, mirrors), curvature(shell, folds), start(folds.rest_angles()) {
    count_all();
}

void CoupledBending::count_all() {
    counted.resize(shell.triangles.size());
    std::iota(counted.begin(), counted.end(), 0);
    needed = folds.present();
}

void CoupledBending::count_only(std::vector<Index> faces) {
    of_all = false;
    counted = std::move(faces);
    find_needed();
}

void CoupledBending::find_needed() {
    std::vector<char> is_needed(folds.size(), 0);
    for (const Index face : counted)
        for (const auto& [fold, per_angle] : curvature.terms(face)) is_needed[fold] = 1;
    needed = folds.present();
    std::erase_if(needed, [&](Index fold) { return is_needed[fold] == 0; });
}

void CoupledBending::start_from(const Positions& x, double factor) {
    start = folds.angles(x);
    scale = factor;
}

std::vector<Index> CoupledBending::follow(const ShellChange& change) {
    std::vector<Index> changed = curvature.follow(change);
    folds.follow(change, start);
    if (of_all)
        count_all();
    else
        find_needed();
    return changed;
}

Matrix3d CoupledBending::rigidity(Index face) const {
    const auto& [vertices, membrane] = shell.triangles[face];
    const double thickness = shell.thickness[vertices[0]];
    return scale * membrane.area * thickness * thickness / 12 * membrane.elasticity;
}

VectorXd CoupledBending::changes(const Positions& x, std::span<const Index> some) const {
    return (folds.angles(x, some) - start).unaryExpr([](double change) {
        return std::remainder(change, 2 * std::numbers::pi);
    });
}

Eigen::Matrix3Xd CoupledBending::curvatures(const Positions& x) const {
    const VectorXd all = changes(x);
    Eigen::Matrix3Xd of_faces(3, shell.triangles.size());
    for (std::size_t face = 0; face < shell.triangles.size(); ++face)
        of_faces.col(static_cast<Eigen::Index>(face)) = curvature.of(face, all);
    return of_faces;
}

std::vector<MirrorGradient> CoupledBending::mirror_gradients(const Positions& x) const {
    return folds.mirror_gradients(x, moments(changes(x, needed)));
}

/// The derivative of the energy by the angles, N m: S dtheta.
VectorXd CoupledBending::moments(const VectorXd& changes) const {
    VectorXd all = VectorXd::Zero(changes.size());
    for (const Index face : counted) {
        const Vector3d moment = rigidity(face) * curvature.of(face, changes);
        for (const auto& [fold, per_angle] : curvature.terms(face)) all[fold] += per_angle.dot(moment);
    }
    return all;
}

double CoupledBending::value(const Positions& x) const {
    const VectorXd all = changes(x, needed);
    double sum = 0;
    for (const Index face : counted) {
        const Vector3d bent = curvature.of(face, all);
        sum += 0.5 * bent.dot(rigidity(face) * bent);
    }
    return sum;
}

double CoupledBending::round_off() const {
    double sum = 0;
    for (const Index face : counted)
        for (const auto& [fold, per_angle] : curvature.terms(face))
            sum += per_angle.dot(rigidity(face) * per_angle);
    return 4 * std::numeric_limits<double>::epsilon() * sum;
}

void CoupledBending::add_gradient(const Positions& x, Positions& gradient) const {
    folds.add_gradient(x, moments(changes(x, needed)), gradient, needed);
}

void CoupledBending::add_hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) const {
    const std::vector<Folds::Slope> all = folds.slopes(x, needed);
    std::vector<VertexCurvature> local;
    for (const Index face : counted) {
        local.clear();
        for (const auto& [fold, per_angle] : curvature.terms(face)) {
            const auto& [vertices, gradient] = all[fold];
            for (int v = 0; v < 4; ++v) {
                if (vertices[v] < 0) continue;
                auto at = std::ranges::find(local, vertices[v], &VertexCurvature::vertex);
                if (at == local.end()) at = local.insert(at, {vertices[v], Matrix3d::Zero()});
                at->slope += per_angle * gradient.col(v).transpose();
            }
        }
        const Matrix3d root = rigidity(face).llt().matrixU();
        for (auto& [vertex, slope] : local) slope = (root * slope).eval();
        for (std::size_t a = 0; a < local.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b)
                hessian.add(local[a].vertex, local[b].vertex, local[a].slope.transpose() * local[b].slope);
    }
    // What the angles' own second derivatives add.
    if (kind == Curvature::exact) folds.add_hessian(x, moments(changes(x, needed)), hessian, needed);
}

void CoupledBending::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    std::vector<Index> vertices;
    for (const Index face : counted) {
        vertices.clear();
        for (const auto& [fold, per_angle] : curvature.terms(face)) folds.collect(fold, vertices);
        add_pairs(pairs, std::span<const Index>(vertices));
    }
}

}  // namespace sherd
