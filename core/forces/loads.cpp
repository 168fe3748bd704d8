// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <stdexcept>

namespace sherd {
namespace {

double fraction(const Load& load, double time) {
    return load.ramp > 0 ? std::clamp(time / load.ramp, 0.0, 1.0) : 1.0;
}

/// Returns `force` moved to the corner at `vertex` of a reshaped face. If several reshaped faces have this
/// corner, the face with the largest share of the parent `from` is taken.
CornerForce at_vertex(const Shell& shell, const ShellChange& change, Index from, Index vertex,
                      CornerForce force) {
    double most = -1;
    for (const auto& [face, parents] : change.reshaped)
        for (int corner = 0; corner < 3; ++corner) {
            if (shell.triangles[face].vertices[corner] != vertex) continue;
            const auto own = std::ranges::find(parents, from, &IndexWithParents::Parent::element);
            const double share = own == parents.end() ? 0 : own->weight;
            if (share <= most) continue;
            most = share;
            force.triangle = face;
            force.corner = corner;
        }
    return force;
}

void follow(const Shell& shell, const ShellChange& change, std::vector<CornerForce>& forces) {
    for (CornerForce& force : forces)
        if (const auto* was = changed_face(change, force.triangle))
            force = at_vertex(shell, change, force.triangle, was->vertices[force.corner], force);
}

void follow(const ShellChange& change, std::vector<FaceForce>& forces) {
    std::map<Index, Vector3d> of_changed;
    for (const auto& [triangle, force] : forces)
        if (changed_face(change, triangle) != nullptr)
            of_changed.try_emplace(triangle, Vector3d::Zero()).first->second += force;
    if (of_changed.empty()) return;
    std::erase_if(forces, [&](const FaceForce& force) { return of_changed.contains(force.triangle); });
    for (const auto& [face, parents] : change.reshaped) {
        FaceForce sum{face, Vector3d::Zero()};
        for (const auto& [parent, share] : parents)
            if (const auto force = of_changed.find(parent); force != of_changed.end())
                sum.force += share * force->second;
        forces.push_back(sum);
    }
}

void follow(const Shell& shell, const ShellChange& change, std::vector<EdgeMoment>& moments) {
    const auto length = [&](const TriangleEdge& side) {
        const auto [from, to, apex] = edge_and_apex(shell, side);
        return (shell.rest.col(to) - shell.rest.col(from)).norm();
    };
    for (std::size_t i = 0, count = moments.size(); i < count; ++i) {
        const std::vector<TriangleEdge> sides = sides_after(shell, change, moments[i].side);
        if (sides.empty()) throw std::runtime_error("a boundary edge that carries a moment has been lost");
        moments[i].side = sides.front();
        if (sides.size() == 1) continue;
        EdgeMoment second = moments[i];
        second.side = sides.back();
        const double share = length(sides.back()) / (length(sides.front()) + length(sides.back()));
        second.moment *= share;
        moments[i].moment *= 1 - share;
        moments.push_back(second);
    }
}

}  // namespace

std::vector<CornerForce> point_forces(const Shell& shell, std::span<const Index> vertices,
                                      const Vector3d& force) {
    std::vector<CornerForce> forces(shell.mass.size(), CornerForce{-1, 0, force});
    for (Index t = 0; t < static_cast<Index>(shell.triangles.size()); ++t)
        for (int corner = 0; corner < 3; ++corner)
            forces[shell.triangles[t].vertices[corner]] = {t, corner, force};
    std::vector<CornerForce> result;
    for (const Index vertex : vertices) {
        result.push_back(forces.at(vertex));
        if (result.back().triangle < 0)
            throw std::out_of_range("point_forces: a vertex belongs to no triangle");
    }
    return result;
}

std::vector<CornerForce> line_forces(const Shell& shell, std::span<const TriangleEdge> sides,
                                     const Vector3d& force) {
    std::vector<CornerForce> result;
    for (const TriangleEdge& side : sides) {
        const auto [from, to, opposite] = edge_and_apex(shell, side);
        const double length = (shell.rest.col(to) - shell.rest.col(from)).norm();
        for (const int turn : {1, 2})
            result.push_back({side.triangle, (side.corner + turn) % 3, length / 2 * force});
    }
    return result;
}

std::vector<FaceForce> area_forces(const Shell& shell, std::span<const Index> triangles,
                                   const Vector3d& force) {
    std::vector<FaceForce> result;
    for (const Index triangle : triangles)
        result.push_back({triangle, shell.triangles[triangle].membrane.area * force});
    return result;
}

double PressedTriangles::value(std::size_t i, const TrianglePositions& x) const {
    const TrianglePositions r = x.colwise() - centre;
    return -(triangles[i].pressure / 6 * r.determinant());
}

TrianglePositions PressedTriangles::gradient(std::size_t i, const TrianglePositions& x) const {
    const TrianglePositions r = x.colwise() - centre;
    TrianglePositions slope;
    for (int c = 0; c < 3; ++c)
        slope.col(c) = -(triangles[i].pressure / 6 * r.col((c + 1) % 3).cross(r.col((c + 2) % 3)));
    return slope;
}

Eigen::Matrix<double, 9, 9> PressedTriangles::hessian(std::size_t i, const TrianglePositions& x,
                                                      Curvature curvature) const {
    Eigen::Matrix<double, 9, 9> blocks = Eigen::Matrix<double, 9, 9>::Zero();
    if (curvature == Curvature::convex) return blocks;
    const TrianglePositions r = x.colwise() - centre;
    for (int c = 0; c < 3; ++c) {
        const int next = (c + 1) % 3;
        const Matrix3d block = triangles[i].pressure / 6 * cross_matrix(r.col((c + 2) % 3));
        blocks.block<3, 3>(3 * c, 3 * next) = block;
        blocks.block<3, 3>(3 * next, 3 * c) = block.transpose();
    }
    return blocks;
}

void LoadEnergy::begin(const StepContext& step) {
    start = shell.position;
    sum_loads(step);
    if (pressed.size() > 0) complete_pressure();
}

void LoadEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    for (Load& load : loads) {
        follow_faces(change, load.pressed);
        if (change.reshaped.empty()) continue;
        follow(shell, change, load.dead);
        follow(change, load.spread);
        follow(shell, change, load.moments);
    }
    begin(step);
}

void LoadEnergy::sum_loads(const StepContext& step) {
    force = Positions::Zero(3, shell.position.cols());
    pressed.triangles.clear();
    turned.triangles.clear();
    for (const Load& load : loads) {
        const double share = step.load * fraction(load, step.end());
        for (const CornerForce& dead : load.dead)
            force.col(shell.triangles[dead.triangle].vertices[dead.corner]) += share * dead.force;
        for (const FaceForce& spread : load.spread)
            for (const Index vertex : shell.triangles[spread.triangle].vertices)
                force.col(vertex) += share / 3 * spread.force;
        for (const Index triangle : load.pressed)
            pressed.triangles.push_back({shell.triangles[triangle].vertices, share * load.pressure});
        for (const EdgeMoment& moment : load.moments)
            turned.triangles.push_back(turned_triangle(shell, moment, share));
    }
}

void LoadEnergy::complete_pressure() {
    pressed.centre.setZero();
    for (const auto& triangle : pressed.triangles)
        pressed.centre +=
            columns(start, triangle.vertices).rowwise().mean() / static_cast<double>(pressed.size());
    for (std::size_t i = 0; i < pressed.size(); ++i) {
        const auto& [vertices, pressure] = pressed.triangles[i];
        const TrianglePositions x = columns(start, vertices), missed = pressed.gradient(i, x);
        const Vector3d area = 0.5 * Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0)));
        for (const Index vertex : vertices) force.col(vertex) += pressure / 3 * area;
        for (int c = 0; c < 3; ++c) force.col(vertices[c]) += missed.col(c);
    }
    start_potential = sum_of_values(pressed, start);
}

double LoadEnergy::value(const Positions& x) const {
    return sum_of_values(pressed, x) + sum_of_values(turned, x) - start_potential -
           force.cwiseProduct(x - start).sum();
}

void LoadEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    gradient -= force;
    add_gradients(pressed, x, gradient);
    add_gradients(turned, x, gradient);
}

void LoadEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    add_hessians(pressed, x, curvature, hessian);
    add_hessians(turned, x, curvature, hessian);
}

void LoadEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    add_patterns(pressed, pairs);
    add_patterns(turned, pairs);
}

}  // namespace sherd
