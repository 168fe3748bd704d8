// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_bending.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elements/dihedral_angle.h"

namespace sherd {
namespace {

std::vector<TriangleEdge> sides_of(const std::vector<MirrorHinge>& hinges) {
    std::vector<TriangleEdge> sides;
    for (const MirrorHinge& hinge : hinges) sides.push_back(hinge.side);
    return sides;
}

/// How the curvature of a face changes with the position of a vertex, 1/m^2.
struct VertexCurvature {
    Index vertex;
    Matrix3d slope;
};

}  // namespace

CoupledBending::CoupledBending(const Shell& shell, const std::vector<MirrorHinge>& hinges)
    : shell(shell), mirrors(shell, hinges), curvature(shell, sides_of(hinges)) {
    start = VectorXd::Zero(curvature.folds_of_edges() + static_cast<Eigen::Index>(shell.edge_hinge.size()));
    for (std::size_t m = 0; m < mirrors.size(); ++m)
        start[static_cast<Eigen::Index>(m)] = hinge_angle(mirrors.rest(m));
    for (std::size_t h = 0; h < shell.hinges.size(); ++h)
        start[curvature.folds_of_edges() + shell.hinge_edge[h]] = shell.hinges[h].rest.angle;
}

void CoupledBending::start_from(const Positions& x, double factor) {
    start = angles(x);
    scale = factor;
}

void CoupledBending::topology_changed(const ShellChange& change, const StepContext&) {
    curvature.follow(change);
    const Eigen::Index known = start.size();
    start.conservativeResize(curvature.folds_of_edges() + static_cast<Eigen::Index>(shell.edge_hinge.size()));
    start.tail(start.size() - known).setZero();
    for (const auto& [edge, parents] : change.edges)
        if (const Index hinge = shell.edge_hinge[edge]; hinge >= 0)
            start[curvature.folds_of_edges() + edge] = shell.hinges[hinge].rest.angle;
}

Matrix3d CoupledBending::rigidity(std::size_t face) const {
    const auto& [vertices, membrane] = shell.triangles[face];
    const double thickness = shell.thickness[vertices[0]];
    return scale * membrane.area * thickness * thickness / 12 * membrane.elasticity;
}

VectorXd CoupledBending::angles(const Positions& x) const {
    VectorXd all = VectorXd::Zero(start.size());
    for (std::size_t m = 0; m < mirrors.size(); ++m)
        all[static_cast<Eigen::Index>(m)] = hinge_angle(mirrors.with_image(m, x));
    for (std::size_t h = 0; h < shell.hinges.size(); ++h)
        all[curvature.folds_of_edges() + shell.hinge_edge[h]] =
            hinge_angle(columns(x, shell.hinges[h].vertices));
    return all;
}

VectorXd CoupledBending::changes(const Positions& x) const {
    return (angles(x) - start).unaryExpr([](double change) {
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
    const VectorXd of_angles = moments(changes(x));
    const std::vector<Slope> all = slopes(x);
    std::vector<MirrorGradient> gradients;
    for (std::size_t m = 0; m < mirrors.size(); ++m)
        gradients.push_back({all[m].vertices, of_angles[static_cast<Eigen::Index>(m)] * all[m].gradient});
    return gradients;
}

/// The derivative of the energy by the angles, N m: S dtheta.
VectorXd CoupledBending::moments(const VectorXd& changes) const {
    VectorXd all = VectorXd::Zero(changes.size());
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const Vector3d moment = rigidity(face) * curvature.of(face, changes);
        for (const auto& [fold, per_angle] : curvature.terms(face)) all[fold] += per_angle.dot(moment);
    }
    return all;
}

double CoupledBending::value(const Positions& x) const {
    const VectorXd all = changes(x);
    double sum = 0;
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const Vector3d bent = curvature.of(face, all);
        sum += 0.5 * bent.dot(rigidity(face) * bent);
    }
    return sum;
}

double CoupledBending::round_off() const {
    double sum = 0;
    for (std::size_t face = 0; face < shell.triangles.size(); ++face)
        for (const auto& [fold, per_angle] : curvature.terms(face))
            sum += per_angle.dot(rigidity(face) * per_angle);
    return 4 * std::numeric_limits<double>::epsilon() * sum;
}

std::array<Index, 4> CoupledBending::vertices_of(Index fold) const {
    if (fold < curvature.folds_of_edges()) {
        const auto [from, to, apex] = mirrors.vertices(fold);
        return {from, to, apex, -1};
    }
    return shell.hinges[shell.edge_hinge[fold - curvature.folds_of_edges()]].vertices;
}

std::vector<CoupledBending::Slope> CoupledBending::slopes(const Positions& x) const {
    std::vector<Slope> all(start.size());
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        all[m] = {vertices_of(static_cast<Index>(m)), DihedralAngle(mirrors.with_image(m, x)).gradient()};
        all[m].gradient.col(2) += mirrors.reflection(m) * all[m].gradient.col(3);
    }
    for (std::size_t h = 0; h < shell.hinges.size(); ++h) {
        const std::array<Index, 4>& vertices = shell.hinges[h].vertices;
        all[curvature.folds_of_edges() + shell.hinge_edge[h]] = {
            vertices, DihedralAngle(columns(x, vertices)).gradient()};
    }
    return all;
}

void CoupledBending::add_gradient(const Positions& x, Positions& gradient) const {
    const VectorXd of_angles = moments(changes(x));
    const std::vector<Slope> all = slopes(x);
    const auto add = [&](Index fold) {
        const Slope& slope = all[fold];
        for (int v = 0; v < 4; ++v)
            if (slope.vertices[v] >= 0)
                gradient.col(slope.vertices[v]) += of_angles[fold] * slope.gradient.col(v);
    };
    for (Index m = 0; m < curvature.folds_of_edges(); ++m) add(m);
    for (const Index edge : shell.hinge_edge) add(curvature.folds_of_edges() + edge);
}

void CoupledBending::add_hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) const {
    const std::vector<Slope> all = slopes(x);
    std::vector<VertexCurvature> local;
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
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
    if (kind == Curvature::convex) return;
    // What the angles' own second derivatives add.
    const VectorXd of_angles = moments(changes(x));
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        HingeHessian full = HingeHessian::Zero();
        DihedralAngle(mirrors.with_image(m, x)).add_hessian(of_angles[static_cast<Eigen::Index>(m)], full);
        add_element(hessian, mirrors.vertices(m), mirrors.folded(m, full));
    }
    for (std::size_t h = 0; h < shell.hinges.size(); ++h) {
        const std::array<Index, 4>& vertices = shell.hinges[h].vertices;
        HingeHessian full = HingeHessian::Zero();
        DihedralAngle(columns(x, vertices))
            .add_hessian(of_angles[curvature.folds_of_edges() + shell.hinge_edge[h]], full);
        add_element(hessian, vertices, full);
    }
}

void CoupledBending::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    std::vector<Index> vertices;
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        vertices.clear();
        for (const auto& [fold, per_angle] : curvature.terms(face))
            for (const Index vertex : vertices_of(fold))
                if (vertex >= 0 && std::ranges::find(vertices, vertex) == vertices.end())
                    vertices.push_back(vertex);
        for (std::size_t a = 0; a < vertices.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) pairs.emplace_back(vertices[a], vertices[b]);
    }
}

}  // namespace sherd
