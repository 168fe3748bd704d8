// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/plane_contact.h"

namespace sherd {
namespace {

constexpr double smoothing_speed = 0.01;  // m/s

}  // namespace

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
        const double limit = sliding_limit(v);
        if (limit == 0) continue;
        const double way = sliding(x, v).norm(), ratio = way / smoothing;
        sum += limit * (ratio < 1 ? smoothing * (ratio * ratio - ratio * ratio * ratio / 3 + 1.0 / 3) : way);
    }
    return sum;
}

void PlaneContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const double depth = overlap(x.col(v), v);
        if (depth > 0) gradient.col(v) -= stiffness(v) * depth * plane.normal;
        const double limit = sliding_limit(v);
        if (limit == 0) continue;
        const Vector3d slip = sliding(x, v);
        const double way = slip.norm(), ratio = way / smoothing;
        gradient.col(v) += limit * slip * (ratio < 1 ? (2 - ratio) / smoothing : 1 / way);
    }
}

void PlaneContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    const Matrix3d normal = plane.normal * plane.normal.transpose(), tangent = Matrix3d::Identity() - normal;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const Index vertex = static_cast<Index>(v);
        if (overlap(x.col(v), v) > 0) hessian.add(vertex, vertex, stiffness(v) * normal);
        const double limit = sliding_limit(v);
        if (limit == 0) continue;
        const Vector3d slip = sliding(x, v);
        const double way = slip.norm(), ratio = way / smoothing;
        // d(f(w) u/w)/du = f/w (I - uu/w2) + f' uu/w2, both parts positive.
        const double across = ratio < 1 ? (2 - ratio) / smoothing : 1 / way;
        const double along = ratio < 1 ? 2 * (1 - ratio) / smoothing : 0;
        Matrix3d block = across * tangent;
        if (way > 0) block += (along - across) / (way * way) * slip * slip.transpose();
        hessian.add(vertex, vertex, limit * block);
    }
}

}  // namespace sherd
