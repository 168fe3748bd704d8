// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/elements/hinge.h"
#include "core/lanes.h"

namespace sherd {

/// Tangent below which the arc tangent's series is used: its remainder is below round-off, and it takes a
/// fraction of the time of std::atan2.
inline constexpr double small_tangent = 0.125;

template <class Real>
Real small_arc_tangent(const Real& tangent) {
    const Real s = tangent * tangent, ss = s * s;
    const Real even = ss * (1. / 5 + ss * (1. / 9 + ss * (1. / 13 + ss * (1. / 17))));
    const Real odd = s * (1. / 3 + ss * (1. / 7 + ss * (1. / 11 + ss * (1. / 15))));
    return tangent + tangent * (even - odd);
}

/// Angle, rad, as of std::atan2(y, x).
inline double arc_tangent(double y, double x) {
    const double tangent = y / x;
    const bool small = x > 0 && tangent * tangent < small_tangent * small_tangent;
    return small ? small_arc_tangent(tangent) : std::atan2(y, x);
}

inline Lanes arc_tangent(const Lanes& y, const Lanes& x) {
    const Lanes tangent = y / x;
    Lanes angle = small_arc_tangent(tangent);
    if (all_less(0, x) && all_less(tangent * tangent, small_tangent * small_tangent)) return angle;
    for (int lane = 0; lane < Lanes::count; ++lane) angle.set(lane, arc_tangent(y[lane], x[lane]));
    return angle;
}

/// The dihedral angle of a hinge (hinge_angle()) with its derivatives, on any deformation. The derivatives
/// are NaN if a triangle has no area. Real: double, or Lanes for four hinges at once.
template <class Real>
class DihedralAngleOf {
  public:
    using Vector = Eigen::Matrix<Real, 3, 1>;
    using HingePositions = Eigen::Matrix<Real, 3, 4>;
    using Turn = Eigen::Matrix<Real, 2, 1>;

    /// x: m.
    explicit DihedralAngleOf(const HingePositions& x)
        : edge(x.col(1) - x.col(0)),
          sides{x.col(2) - x.col(0), x.col(3) - x.col(0)},
          normals{edge.cross(sides[0]), sides[1].cross(edge)},
          length(edge.norm()) {}
    /// The angle, rad. For small angles no trigonometric function is evaluated.
    Real angle() const {
        const Turn turn = scaled_turn();
        return arc_tangent(turn[1], turn[0]);
    }
    /// The angle, rad, less the angle whose cos and sin are `from`, between -pi and pi.
    Real angle_from(const Turn& from) const {
        const Turn turn = scaled_turn();
        return arc_tangent(turn[1] * from[0] - turn[0] * from[1], turn.dot(from));
    }
    /// cos and sin of the angle. No trigonometric function is evaluated.
    Turn turn() const { return scaled_turn().normalized(); }
    Real edge_length() const { return length; }  ///< m
    /// d(theta)/dx, 1/m, [3, 4]. Each triangle rotates by the displacement of its apex along its normal, over
    /// its height.
    HingePositions gradient() const;
    /// Adds `factor` times d2(theta)/dx2, [12, 12], coordinate fastest.
    void add_hessian(Real factor, Eigen::Matrix<Real, 12, 12>& hessian) const;

  private:
    Turn scaled_turn() const {  ///< m^4, cos and sin times both doubled areas
        return {normals[0].dot(normals[1]), length * normals[0].dot(sides[1])};
    }
    /// Weight of x1 in the foot of an apex's height on the edge; x0 has the weight 1 - foot(side).
    Real foot(int side) const { return sides[side].dot(edge) / (length * length); }

    Vector edge;        ///< m, from x0 to x1
    Vector sides[2];    ///< m, from x0 to each apex
    Vector normals[2];  ///< m^2, doubled area along the normal; parallel in a flat hinge
    Real length;        ///< m, of the edge
};

using DihedralAngle = DihedralAngleOf<double>;
template <>
void DihedralAngle::add_hessian(double factor, HingeHessian& hessian) const;

template <class Real>
typename DihedralAngleOf<Real>::HingePositions DihedralAngleOf<Real>::gradient() const {
    HingePositions g;
    const Real feet[2] = {foot(0), foot(1)};
    for (const int side : {0, 1}) g.col(2 + side) = length / normals[side].squaredNorm() * normals[side];
    g.col(0) = (feet[0] - 1) * g.col(2) + (feet[1] - 1) * g.col(3);
    g.col(1) = -feet[0] * g.col(2) - feet[1] * g.col(3);
    return g;
}

}  // namespace sherd
