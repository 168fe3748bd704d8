// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/nonlinear_hinge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

using HingeVector = Eigen::Matrix<double, 12, 1>;

/// A triangle (x0, x1, apex) of the hinge, with the orthonormal frame of the common edge. Displacements dx of
/// its vertices move the apex by sum_i from_foot[i] dx_i relative to the material point of the edge below it.
struct Flap {
    Vector3d along;      ///< unit vector of the edge
    Vector3d across;     ///< unit vector in the triangle, from the edge to the apex
    Vector3d normal;     ///< along x across
    Vector3d from_foot;  ///< weights of x0, x1, apex
    double length;       ///< m, of the edge
    double height;       ///< m, of the apex over the edge
};

Flap flap(const HingePositions& x, int apex) {
    const Vector3d edge = x.col(1) - x.col(0), side = x.col(apex) - x.col(0);
    const Vector3d twice_area = edge.cross(side);
    Flap f;
    f.length = edge.norm();
    f.height = twice_area.norm() / f.length;
    f.along = edge / f.length;
    f.normal = twice_area / twice_area.norm();
    f.across = f.normal.cross(f.along);
    const double foot = side.dot(edge) / edge.squaredNorm();
    f.from_foot = Vector3d(foot - 1, -foot, 1);
    return f;
}

/// cos and sin of theta. The two normals of a flat hinge are opposite, since both triangles start at x0.
Vector2d turn_of(const std::array<Flap, 2>& flaps) {
    return {-flaps[0].normal.dot(flaps[1].normal), flaps[0].normal.dot(flaps[1].across)};
}

/// cos and sin of theta - thetabar.
Vector2d turn_from_rest(const NonlinearHinge& hinge, const Vector2d& turn) {
    const Vector2d& rest = hinge.rest_turn;
    return {turn.dot(rest), turn[1] * rest[0] - turn[0] * rest[1]};
}

std::array<Flap, 2> flaps_of(const HingePositions& x) {
    return {flap(x, 2), flap(x, 3)};
}

/// d(theta)/dx: each triangle rotates by the displacement of its apex along its normal, over its height.
HingePositions angle_gradient(const std::array<Flap, 2>& flaps) {
    HingePositions g = HingePositions::Zero();
    for (const int side : {0, 1}) {
        const Flap& f = flaps[side];
        const Vector3d turn = (side == 0 ? 1 : -1) / f.height * f.normal;
        g.col(0) += f.from_foot[0] * turn;
        g.col(1) += f.from_foot[1] * turn;
        g.col(2 + side) = turn;
    }
    return g;
}

/// Adds factor d2(theta)/dx2. The contribution of a triangle to the gradient is from_foot[i] normal / height.
/// With w = from_foot, d = (-1, 1, 0), l and h the length and the height, and the frame (a, c, n) = (along,
/// across, normal), its derivative is
///     -(w_i w_j (c n^T + n c^T) / h^2 + w_i d_j a n^T / (h l) + d_i w_j n a^T / (h l)
///       + d_i d_j n c^T / l^2).
/// The last term is symmetric only when summed over both triangles; its symmetric part has the same sum.
/// Compare Tamstorf and Grinspun, Discrete bending forces and their Jacobians (2013).
void add_angle_hessian(const std::array<Flap, 2>& flaps, double factor, HingeHessian& hessian) {
    constexpr double d[3] = {-1, 1, 0};
    for (const int side : {0, 1}) {
        const Flap& f = flaps[side];
        const double scale = side == 0 ? -factor : factor;
        const Matrix3d cn = f.across * f.normal.transpose(), symmetric = scale * (cn + cn.transpose());
        const Matrix3d both_apex = symmetric / (f.height * f.height);
        const Matrix3d both_edge = symmetric / (2 * f.length * f.length);
        const Matrix3d mixed = scale / (f.height * f.length) * f.along * f.normal.transpose();
        const int vertex[3] = {0, 1, 2 + side};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                hessian.block<3, 3>(3 * vertex[i], 3 * vertex[j]) +=
                    f.from_foot[i] * f.from_foot[j] * both_apex + f.from_foot[i] * d[j] * mixed +
                    d[i] * f.from_foot[j] * mixed.transpose() + d[i] * d[j] * both_edge;
    }
}

}  // namespace

NonlinearHinge nonlinear_hinge(const HingePositions& rest, double stiffness) {
    const RestHinge geometry = rest_hinge(rest);
    NonlinearHinge hinge;
    hinge.scale = 3 * stiffness * geometry.edge_length * geometry.edge_length / geometry.area;
    hinge.rest_turn = turn_of(flaps_of(rest));
    return hinge;
}

double value(const NonlinearHinge& hinge, const HingePositions& x) {
    // This is 1 - cos without its cancellation.
    return 0.5 * hinge.scale * (turn_of(flaps_of(x)) - hinge.rest_turn).squaredNorm();
}

double round_off(const NonlinearHinge& hinge) {
    return 4 * std::numeric_limits<double>::epsilon() * hinge.scale;
}

HingePositions gradient(const NonlinearHinge& hinge, const HingePositions& x) {
    const std::array<Flap, 2> flaps = flaps_of(x);
    return hinge.scale * turn_from_rest(hinge, turn_of(flaps))[1] * angle_gradient(flaps);
}

HingeHessian hessian(const NonlinearHinge& hinge, const HingePositions& x, bool convex) {
    const std::array<Flap, 2> flaps = flaps_of(x);
    const Vector2d turn = hinge.scale * turn_from_rest(hinge, turn_of(flaps));
    const HingeVector slope = angle_gradient(flaps).reshaped();
    HingeHessian h = (convex ? std::max(turn[0], 0.0) : turn[0]) * slope * slope.transpose();
    if (!convex) add_angle_hessian(flaps, turn[1], h);
    return h;
}

}  // namespace sherd
