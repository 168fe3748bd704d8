// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace sherd {

/// The gradient, N, [3, 3], by the corners of a triangle of an energy that depends on the dihedral angles at
/// its sides, as far as these come from its own rotation. Side c is opposite corner c. edges: m, along the
/// sides in the triangle's order of corners, [3, 3]; moments: derivatives of the energy by the angles over
/// the sides' lengths, N.
///
/// An angle turns by the displacement of its apex along the normal, over the height, and at the ends of the
/// side by the shares of these in the foot of the apex (DihedralAngle::gradient()). With the normal n, as
/// long as twice the area, that is (e_i . e_c) n / (n^2 l_c) at corner i. Real: double, or Lanes for four.
template <class Real>
Eigen::Matrix<Real, 3, 3> fold_gradient(const Eigen::Matrix<Real, 3, 3>& edges,
                                        const Eigen::Matrix<Real, 3, 1>& moments) {
    using Vector = Eigen::Matrix<Real, 3, 1>;
    const Vector normal = edges.col(0).cross(edges.col(1));
    Vector along = moments[0] * edges.col(0);
    for (int side = 1; side < 3; ++side) along += moments[side] * edges.col(side);
    const Vector scaled = Real(1) / normal.squaredNorm() * normal;
    Eigen::Matrix<Real, 3, 3> gradient;
    for (int corner = 0; corner < 3; ++corner) gradient.col(corner) = edges.col(corner).dot(along) * scaled;
    return gradient;
}

}  // namespace sherd
