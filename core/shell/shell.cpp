// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/shell.h"

#include <Eigen/Geometry>

namespace sherd {
namespace {

void resize(Positions& columns, Index count) {
    const Eigen::Index before = columns.cols();
    columns.conservativeResize(3, count);
    if (count > before) columns.rightCols(count - before).setZero();
}

void resize(VectorXd& values, Index count) {
    const Eigen::Index before = values.size();
    values.conservativeResize(count);
    if (count > before) values.tail(count - before).setZero();
}

template <class T>
void resize(std::vector<T>& values, Index count, Inheritance, const T& missing) {
    values.resize(count, missing);
}

}  // namespace

void Shell::visit_state(StateVisitor& visit) {
    auto& [rest, position, velocity, mass, thickness, young, footprint, fixed, script, guide, support_set,
           vertex_sheet, kept, triangles, face_mass, face_sheet, face_axis, edge_hinge, edge_strength,
           edge_toughness, edge_strength_factor, edge_toughness_factor, edge_kept, hinges, hinge_edge,
           exempt_pairs, near, start_depths, crack_faces, guides, motions, support_sets, uneven] = *this;
    std::size_t colliders = start_depths.size();
    visit(colliders);
    start_depths.resize(colliders);
    const auto visit_list = [&](auto& values, const auto&...) { visit(values); };
    visit_vertices(*this, visit_list);
    visit_edges(*this, visit_list);
    visit_faces(*this, visit_list);
    visit(hinges, hinge_edge, exempt_pairs, near, crack_faces);
}

void resize_vertices(Shell& shell, Index count) {
    visit_vertices(shell, [count](auto& values, const auto&... rule) { resize(values, count, rule...); });
}

void follow(Shell& shell, const ShellChange& change) {
    visit_vertices(shell, [&](auto& values, const auto&... rule) {
        if constexpr (std::is_same_v<decltype(values), Positions&>)
            follow(values, change);
        else
            append(values, change.vertices, rule...);
    });
    if (shell.uneven) follow_moves(shell.thickness, change.moved);
    visit_edges(shell, [&](auto& values, Inheritance rule, const auto& missing) {
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>)
            if (rule == Inheritance::around) return follow_around(values, change, missing);
        append(values, change.edges, rule, missing);
    });
    visit_faces(shell, [&](auto& values, const auto&... rule) { append(values, change.faces, rule...); });
}

Index remove_hinge_of(Shell& shell, Index edge) {
    const Index hinge = shell.edge_hinge[edge];
    shell.edge_hinge[shell.hinge_edge.back()] = hinge;
    shell.edge_hinge[edge] = -1;
    remove_hinge(shell.hinge_edge, hinge);
    remove_hinge(shell.hinges, hinge);
    return hinge;
}

HingeStencil hinge_stencil(const Shell& shell, const std::array<Index, 4>& vertices, double stiffness) {
    return {vertices, rest_hinge(columns(shell.rest, vertices)), stiffness};
}

Vector3d linear_momentum(const Shell& shell) {
    return shell.velocity * shell.mass;
}

Vector3d angular_momentum(const Shell& shell) {
    Vector3d sum = Vector3d::Zero();
    for (Eigen::Index v = 0; v < shell.mass.size(); ++v)
        sum += shell.mass[v] * shell.position.col(v).cross(shell.velocity.col(v));
    return sum;
}

}  // namespace sherd
