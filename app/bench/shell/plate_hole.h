// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// An infinite plate of rigidity 1 in the plane z = 0 with a hole of radius 1 about the origin, bent so that
/// m_xx = 1 far away: Goodier, The influence of circular and elliptical holes on the transverse flexure of
/// elastic plates, Phil. Mag. 22 (1936). Moments are positive where they stretch the side z > 0: with the
/// deflection w along z, m = -((1 - nu) grad grad w + nu tr(grad grad w) 1). p is a point with |p| >= 1.
class PlateHole {
  public:
    explicit PlateHole(double poisson);
    Eigen::Matrix2d moments(const Vector2d& p) const;  ///< m_xx, m_xy, m_yy
    Vector2d shear(const Vector2d& p) const;           ///< shear force: the divergence of the moments
    double rim_moment() const;                         ///< m_xx where the rim crosses the y axis

  private:
    double poisson;
    double axial;          ///< factor of ln r in w, in polar coordinates r and angle
    double square;         ///< factor of -r^2 cos(2 angle) in w
    double even, inverse;  ///< factors of cos(2 angle) and of cos(2 angle) / r^2 in w
};

}  // namespace sherd
