// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "core/vector.h"

namespace sherd {

// Exact stresses in an infinite sheet, and moments in an infinite Kirchhoff plate, with a straight crack
// whose middle is the origin (method of Muskhelishvili, Some Basic Problems of the Mathematical Theory of
// Elasticity, 1953).

/// A sheet that is pulled along y by the stress 1.
class PulledSheet {
  public:
    /// half_length: of the crack, m; angle: between the crack and the x axis, rad.
    PulledSheet(double half_length, double angle);
    Eigen::Matrix2d stress(const Vector2d& at) const;
    double opening() const;  ///< K_I over the stress, m^0.5
    double shear() const;    ///< magnitude of K_II over the stress, m^0.5

  private:
    double half_length, angle;
    std::complex<double> traction;       ///< s_yy - i s_xy far away, in the crack's frame
    double across, shear_stress, along;  ///< s_yy, s_xy and s_xx far away, in the crack's frame
};

/// A plate that has a crack on the x axis and is bent along y: m_yy = 1 far away. Moments are positive where
/// they stretch the side z > 0.
class CrackedPlate {
  public:
    CrackedPlate(double half_length, double poisson) : half_length(half_length), poisson(poisson) {}
    Eigen::Matrix2d moments(const Vector2d& at) const;  ///< m_xx, m_xy, m_yy
    Vector2d shear(const Vector2d& at) const;           ///< shear force: the divergence of the moments

  private:
    double half_length, poisson;
};

}  // namespace sherd
