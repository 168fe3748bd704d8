// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/dihedral_angle.h"

#include <Eigen/Geometry>

namespace sherd {

DihedralAngle::Flap DihedralAngle::flap(const HingePositions& x, int apex) {
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

/// The two normals of a flat hinge are opposite, since both triangles start at x0.
Vector2d DihedralAngle::turn() const {
    return {-flaps[0].normal.dot(flaps[1].normal), flaps[0].normal.dot(flaps[1].across)};
}

/// Each triangle rotates by the displacement of its apex along its normal, over its height.
HingePositions DihedralAngle::gradient() const {
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

/// The contribution of a triangle to the gradient is from_foot[i] normal / height. With w = from_foot,
/// d = (-1, 1, 0), l and h the length and the height, and the frame (a, c, n) = (along, across, normal), its
/// derivative is
///     -(w_i w_j (c n^T + n c^T) / h^2 + w_i d_j a n^T / (h l) + d_i w_j n a^T / (h l)
///       + d_i d_j n c^T / l^2).
/// The last term is symmetric only when summed over both triangles; its symmetric part has the same sum.
/// Compare Tamstorf and Grinspun, Discrete bending forces and their Jacobians (2013).
void DihedralAngle::add_hessian(double factor, HingeHessian& hessian) const {
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

}  // namespace sherd
