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
    for (Positions* columns : {&sheet.rest, &sheet.position, &sheet.velocity}) resize(*columns, count);
    for (VectorXd* values : {&sheet.mass, &sheet.thickness, &sheet.young, &sheet.footprint})
        resize(*values, count);
    sheet.fixed.resize(count, 0);
    sheet.carrier.resize(count, 0);
    sheet.guide.resize(count, 0);
    sheet.body.resize(count, 0);
}

void copy_vertex(Sheet& sheet, Index from, Index to) {
    for (Positions* columns : {&sheet.rest, &sheet.position, &sheet.velocity})
        columns->col(to) = columns->col(from);
    for (VectorXd* values : {&sheet.mass, &sheet.thickness, &sheet.young, &sheet.footprint})
        (*values)[to] = (*values)[from];
    sheet.fixed[to] = sheet.fixed[from];
    sheet.carrier[to] = sheet.carrier[from];
    sheet.guide[to] = sheet.guide[from];
    sheet.body[to] = sheet.body[from];
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
