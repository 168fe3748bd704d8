// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/barrier/edge_mollifier.h"

#include <Eigen/Geometry>

namespace sherd {
namespace {

/// c = |u x v|^2 of the edge vectors u and v, and its first and second derivatives by u and v.
struct Crossing {
    Vector3d u, v;

    explicit Crossing(const PairPositions& x) : u(x.col(1) - x.col(0)), v(x.col(3) - x.col(2)) {}
    double value() const { return u.cross(v).squaredNorm(); }
    Vector3d by_u() const { return 2 * v.cross(u.cross(v)); }
    Vector3d by_v() const { return 2 * u.cross(v.cross(u)); }
    /// Second derivative by one edge vector, where `other` is the other edge vector.
    static Matrix3d by_same(const Vector3d& other) {
        return 2 * (other.squaredNorm() * Matrix3d::Identity() - other * other.transpose());
    }
    Matrix3d by_u_and_v() const {  // row: component of u, column: component of v
        return 4 * u * v.transpose() - 2 * v * u.transpose() - 2 * u.dot(v) * Matrix3d::Identity();
    }
};

PairPositions gradient_of(const Crossing& crossing) {
    PairPositions g;
    g << -crossing.by_u(), crossing.by_u(), -crossing.by_v(), crossing.by_v();
    return g;
}

}  // namespace

bool EdgeMollifier::active(const PairPositions& x) const {
    return Crossing(x).value() < threshold;
}

double EdgeMollifier::value(const PairPositions& x) const {
    const double ratio = Crossing(x).value() / threshold;
    return ratio < 1 ? ratio * (2 - ratio) : 1;
}

PairPositions EdgeMollifier::gradient(const PairPositions& x) const {
    const Crossing crossing(x);
    const double ratio = crossing.value() / threshold;
    if (!(ratio < 1)) return PairPositions::Zero();
    return 2 * (1 - ratio) / threshold * gradient_of(crossing);
}

PairHessian EdgeMollifier::hessian(const PairPositions& x) const {
    const Crossing crossing(x);
    const double ratio = crossing.value() / threshold;
    if (!(ratio < 1)) return PairHessian::Zero();
    Eigen::Matrix<double, 6, 6> by_edges;
    by_edges << Crossing::by_same(crossing.v), crossing.by_u_and_v(), crossing.by_u_and_v().transpose(),
        Crossing::by_same(crossing.u);
    PairHessian h;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            h.block<3, 3>(3 * i, 3 * j) =
                (i % 2 == j % 2 ? 1 : -1) * by_edges.block<3, 3>(3 * (i / 2), 3 * (j / 2));
    const PairPositions g = gradient_of(crossing);
    const Eigen::Matrix<double, 12, 1> flat = g.reshaped();
    return 2 / threshold * ((1 - ratio) * h - flat * flat.transpose() / threshold);
}

}  // namespace sherd
