// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/sheet.h"

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

}  // namespace

void resize_vertices(Sheet& sheet, Index count) {
    visit_vertices(sheet, [count](auto& values, auto... rule) {
        if constexpr (sizeof...(rule) == 0)
            resize(values, count);
        else
            values.resize(count, 0);
    });
}

void follow(Sheet& sheet, const ShellChange& change) {
    const auto append_to = [](const std::vector<Heir>& heirs) {
        return [&heirs](auto& values, const auto&... rule) { append(values, heirs, rule...); };
    };
    visit_vertices(sheet, append_to(change.vertices));
    visit_edges(sheet, append_to(change.edges));
    visit_faces(sheet, append_to(change.faces));
}

Index remove_hinge_of(Sheet& sheet, Index edge) {
    const Index hinge = sheet.edge_hinge[edge];
    sheet.edge_hinge[sheet.hinge_edge.back()] = hinge;
    sheet.edge_hinge[edge] = -1;
    remove_hinge(sheet.hinge_edge, hinge);
    remove_hinge(sheet.hinges, hinge);
    return hinge;
}

HingeStencil hinge_stencil(const Sheet& sheet, const std::array<Index, 4>& vertices, double stiffness) {
    return {vertices, rest_hinge(columns(sheet.rest, vertices)), stiffness};
}

double kinetic_energy(const Sheet& sheet) {
    return 0.5 * sheet.mass.dot(sheet.velocity.colwise().squaredNorm().transpose());
}

Vector3d linear_momentum(const Sheet& sheet) {
    return sheet.velocity * sheet.mass;
}

Vector3d angular_momentum(const Sheet& sheet) {
    Vector3d sum = Vector3d::Zero();
    for (Eigen::Index v = 0; v < sheet.mass.size(); ++v)
        sum += sheet.mass[v] * sheet.position.col(v).cross(sheet.velocity.col(v));
    return sum;
}

}  // namespace sherd
