// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "core/vector.h"

namespace sherd {

// Stresses of infinite sheets with a straight crack about the origin, far and near (Muskhelishvili,
// Some Basic Problems of the Mathematical Theory of Elasticity, 1953, and the same of Kirchhoff's plates).

/// A sheet that is pulled along y by the stress 1.
class PulledSheet {
  public:
    /// angle: of the crack from the x axis, rad.
    PulledSheet(double half_length, double angle);
    Eigen::Matrix2d stress(const Vector2d& at) const;
    double opening() const;  ///< K_I, m^0.5
    double shear() const;    ///< size of K_II, m^0.5

  private:
    double half_length, angle;
    std::complex<double> traction;  ///< on the crack's line far away, in the crack's frame
    double across, shear_stress, along;
};

/// A plate with a crack on the x axis that is bent along y: m_yy = 1 far away, positive where it stretches
/// the side z > 0.
class CrackedPlate {
  public:
    CrackedPlate(double half_length, double poisson) : half_length(half_length), poisson(poisson) {}
    Eigen::Matrix2d moments(const Vector2d& at) const;  ///< m_xx, m_xy, m_yy
    Vector2d shear(const Vector2d& at) const;           ///< the divergence of the moments

  private:
    double half_length, poisson;
};

}  // namespace sherd
