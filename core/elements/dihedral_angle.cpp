// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/dihedral_angle.h"

namespace sherd {

/// The contribution of a triangle to the gradient at vertex i is w_i n / h. Here w are the weights of x0, x1
/// and the apex in the displacement of the apex relative to the foot of its height on the edge; n is the
/// normal and h the height. With d = (-1, 1, 0), the edge's length l, and the frame (a, c, n) along the edge,
/// across it and along n = a x c, the derivative of this contribution is
///     -(w_i w_j (c n^T + n c^T) / h^2 + w_i d_j a n^T / (h l) + d_i w_j n a^T / (h l)
///       + d_i d_j n c^T / l^2).
/// The last term is symmetric only when summed over both triangles; its symmetric part, which is used here,
/// has the same sum. Compare Tamstorf and Grinspun, Discrete bending forces and their Jacobians (2013).
template <>
void DihedralAngle::add_hessian(double factor, HingeHessian& hessian) const {
    constexpr double d[3] = {-1, 1, 0};
    const Vector3d along = edge / length;
    for (const int side : {0, 1}) {
        const double sign = side == 0 ? 1 : -1, scale = -sign * factor;
        const double twice_area = normals[side].norm(), height = twice_area / length;
        const Vector3d normal = sign / twice_area * normals[side], across = normal.cross(along);
        const Vector3d weights(foot(side) - 1, -foot(side), 1);
        const Matrix3d cn = across * normal.transpose(), symmetric = scale * (cn + cn.transpose());
        const Matrix3d both_apex = symmetric / (height * height);
        const Matrix3d both_edge = symmetric / (2 * length * length);
        const Matrix3d mixed = scale / (height * length) * along * normal.transpose();
        const int vertex[3] = {0, 1, 2 + side};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                hessian.block<3, 3>(3 * vertex[i], 3 * vertex[j]) +=
                    weights[i] * weights[j] * both_apex + weights[i] * d[j] * mixed +
                    d[i] * weights[j] * mixed.transpose() + d[i] * d[j] * both_edge;
    }
}

}  // namespace sherd
