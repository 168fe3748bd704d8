// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/basic_shapes.h"

#include <cmath>
#include <limits>

namespace sherd {
namespace {

/// Signed distance, in N dimensions, of a point in the positive octant from a box centred at the origin.
template <int N>
struct OctantDistance {
    using Vector = Eigen::Matrix<double, N, 1>;
    double distance;
    Vector gradient = Vector::Zero();
    Eigen::Matrix<double, N, N> hessian = Eigen::Matrix<double, N, N>::Zero();

    /// beyond: the point's coordinates less the coordinates of the box's corner in that octant, m.
    explicit OctantDistance(const Vector& beyond) {
        Eigen::Index nearest = 0;
        distance = beyond.maxCoeff(&nearest);
        gradient[nearest] = 1;
        if ((beyond.array() > 0).count() < 2) return;
        const Vector outside = beyond.cwiseMax(0);
        distance = outside.norm();
        gradient = outside / distance;
        const Vector taking_part = (beyond.array() > 0).template cast<double>();
        hessian = taking_part.asDiagonal();
        hessian = (hessian - gradient * gradient.transpose()).eval() / distance;
    }
};

}  // namespace

SurfaceDistance PlaneShape::distance(const Vector3d& at) const {
    return {normal.dot(at - point), normal, Matrix3d::Zero()};
}

Eigen::AlignedBox3d PlaneShape::bounds() const {
    const Vector3d all = Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::AlignedBox3d box(-all, all);
    for (int axis = 0; axis < 3; ++axis) {  // a tight box for a floor, since most vertices are above it
        if (normal == Vector3d::Unit(axis)) box.max()[axis] = point[axis];
        if (normal == -Vector3d::Unit(axis)) box.min()[axis] = point[axis];
    }
    return box;
}

SurfaceDistance SphereShape::distance(const Vector3d& at) const {
    const double away = (at - centre).norm();
    if (away == 0) return {-radius, Vector3d::UnitZ(), Matrix3d::Zero()};
    const Vector3d normal = (at - centre) / away;
    return {away - radius, normal, (Matrix3d::Identity() - normal * normal.transpose()) / away};
}

Eigen::AlignedBox3d SphereShape::bounds() const {
    const Vector3d reach = Vector3d::Constant(radius);
    return {centre - reach, centre + reach};
}

SurfaceDistance BoxShape::distance(const Vector3d& at) const {
    const Vector3d from = at - centre;
    const Vector3d side = (from.array() < 0).select(Vector3d::Constant(-1), Vector3d::Ones());
    const OctantDistance<3> octant(from.cwiseAbs() - half);
    return {octant.distance, side.cwiseProduct(octant.gradient),
            side.asDiagonal() * octant.hessian * side.asDiagonal()};
}

Eigen::AlignedBox3d BoxShape::bounds() const {
    return {centre - half, centre + half};
}

SurfaceDistance CylinderShape::distance(const Vector3d& at) const {
    const double along = axis.dot(at - centre);
    const Vector3d across = at - centre - along * axis, end = along < 0 ? Vector3d(-axis) : axis;
    const double away = across.norm();
    const Vector3d outward = away > 0 ? Vector3d(across / away) : axis.unitOrthogonal();
    const OctantDistance<2> section({away - radius, std::abs(along) - 0.5 * length});
    Eigen::Matrix<double, 3, 2> frame;
    frame << outward, end;
    Matrix3d hessian = frame * section.hessian * frame.transpose();
    if (away > 0)
        hessian += section.gradient[0] / away *
                   (Matrix3d::Identity() - axis * axis.transpose() - outward * outward.transpose());
    return {section.distance, frame * section.gradient, hessian};
}

Eigen::AlignedBox3d CylinderShape::bounds() const {
    const Vector3d reach =
        0.5 * length * axis.cwiseAbs() + radius * (1 - axis.array().square()).max(0).sqrt().matrix();
    return {centre - reach, centre + reach};
}

SurfaceDistance OpenSurface::distance(const Vector3d&) const {
    return {std::numeric_limits<double>::infinity(), Vector3d::Zero(), Matrix3d::Zero()};
}

Eigen::AlignedBox3d OpenSurface::bounds() const {
    return {};
}

}  // namespace sherd
