// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace sherd {

/// Returns the gradient, N, [3, 3], by the positions of a triangle's corners, of an energy of the dihedral
/// angles at the triangle's sides; only the rotation of the triangle itself counts, not that of its
/// neighbours. Side c is opposite to corner c. edges: [3, 3] m, vectors along the sides in the triangle's
/// order of corners; moments: N, derivatives of the energy by the angles over the sides' lengths.
///
/// The angle at side c changes by the displacement of corner c along the normal, over its height, less the
/// displacements of the side's ends times their weights in the foot of this height
/// (DihedralAngle::gradient()). With the edges e, the normal n, whose length is twice the area, and the
/// side's length l_c, the angle's gradient at corner i is (e_i . e_c) n / (n^2 l_c). Real: double, or Lanes
/// for four triangles.
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
