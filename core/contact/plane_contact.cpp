// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/plane_contact.h"

#include "core/contact/friction.h"

namespace sherd {
PlaneContact::PlaneContact(const Sheet& sheet, const Plane& plane, double step)
    : sheet(sheet), plane(plane), smoothing(smoothing_speed * step) {}

double PlaneContact::stiffness(Eigen::Index vertex) const {
    return sheet.footprint[vertex] / sheet.thickness[vertex] / (1 / sheet.young[vertex] + 1 / plane.young);
}

double PlaneContact::overlap(const Vector3d& x, Eigen::Index vertex) const {
    return 0.5 * sheet.thickness[vertex] - plane.normal.dot(x - plane.point);
}

double PlaneContact::sliding_limit(Eigen::Index vertex) const {
    if (plane.friction == 0) return 0;
    const double depth = overlap(sheet.position.col(vertex), vertex);
    return depth > 0 ? plane.friction * stiffness(vertex) * depth : 0;
}

Vector3d PlaneContact::sliding(const Positions& x, Eigen::Index vertex) const {
    const Vector3d moved = x.col(vertex) - sheet.position.col(vertex);
    return moved - plane.normal * plane.normal.dot(moved);
}

double PlaneContact::stored_energy(const Positions& x) const {
    double sum = 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const double depth = overlap(x.col(v), v);
        if (depth > 0) sum += 0.5 * stiffness(v) * depth * depth;
    }
    return sum;
}

Index PlaneContact::contacts(const Positions& x) const {
    Index count = 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) count += overlap(x.col(v), v) > 0;
    return count;
}

double PlaneContact::value(const Positions& x) const {
    double sum = stored_energy(x);
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const Friction friction{sliding_limit(v), smoothing};
        if (friction.limit > 0) sum += friction.value(sliding(x, v));
    }
    return sum;
}

void PlaneContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const double depth = overlap(x.col(v), v);
        if (depth > 0) gradient.col(v) -= stiffness(v) * depth * plane.normal;
        const Friction friction{sliding_limit(v), smoothing};
        if (friction.limit > 0) gradient.col(v) += friction.gradient(sliding(x, v));
    }
}

void PlaneContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    const Matrix3d normal = plane.normal * plane.normal.transpose(), tangent = Matrix3d::Identity() - normal;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const Index vertex = static_cast<Index>(v);
        if (overlap(x.col(v), v) > 0) hessian.add(vertex, vertex, stiffness(v) * normal);
        const Friction friction{sliding_limit(v), smoothing};
        if (friction.limit > 0) hessian.add(vertex, vertex, friction.hessian(sliding(x, v), tangent));
    }
}

}  // namespace sherd
