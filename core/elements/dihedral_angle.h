// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/elements/hinge.h"

namespace sherd {

/// The dihedral angle of a hinge (hinge_angle()) with its derivatives, on any deformation; these are NaN
/// where a triangle has no area.
class DihedralAngle {
  public:
    /// x: m.
    explicit DihedralAngle(const HingePositions& x)
        : edge(x.col(1) - x.col(0)),
          sides{x.col(2) - x.col(0), x.col(3) - x.col(0)},
          normals{edge.cross(sides[0]), sides[1].cross(edge)},
          length(edge.norm()) {}
    double angle() const;  ///< rad
    /// cos and sin of the angle. No trigonometric function is evaluated.
    Vector2d turn() const { return scaled_turn().normalized(); }
    /// d(theta)/dx, 1/m, [3, 4]. Each triangle rotates by the displacement of its apex along its normal, over
    /// its height.
    HingePositions gradient() const;
    /// Adds factor d2(theta)/dx2, [12, 12], coordinate fastest.
    void add_hessian(double factor, HingeHessian& hessian) const;

  private:
    static constexpr double small_tangent = 0.125;

    Vector2d scaled_turn() const {  ///< m^4, times the product of the triangles' doubled areas
        return {normals[0].dot(normals[1]), length * normals[0].dot(sides[1])};
    }
    /// Share of x1 in the foot of an apex on the edge; that of x0 is what it lacks of one.
    double foot(int side) const { return sides[side].dot(edge) / (length * length); }

    Vector3d edge;        ///< m, from x0 to x1
    Vector3d sides[2];    ///< m, from x0 to each apex
    Vector3d normals[2];  ///< m^2, doubled area along the normal; both point the same way in a flat hinge
    double length;        ///< m, of the edge
};

/// Of a small tangent by the arc tangent's series, whose rest is below round-off, in a fraction of the time
/// of std::atan2.
inline double DihedralAngle::angle() const {
    const Vector2d turn = scaled_turn();
    const double tangent = turn[1] / turn[0], s = tangent * tangent, ss = s * s;
    if (!(turn[0] > 0 && s < small_tangent * small_tangent)) return std::atan2(turn[1], turn[0]);
    const double even = ss * (1. / 5 + ss * (1. / 9 + ss * (1. / 13 + ss * (1. / 17))));
    const double odd = s * (1. / 3 + ss * (1. / 7 + ss * (1. / 11 + ss * (1. / 15))));
    return tangent + tangent * (even - odd);
}

inline HingePositions DihedralAngle::gradient() const {
    HingePositions g;
    const double feet[2] = {foot(0), foot(1)};
    for (const int side : {0, 1}) g.col(2 + side) = length / normals[side].squaredNorm() * normals[side];
    g.col(0) = (feet[0] - 1) * g.col(2) + (feet[1] - 1) * g.col(3);
    g.col(1) = -feet[0] * g.col(2) - feet[1] * g.col(3);
    return g;
}

}  // namespace sherd
