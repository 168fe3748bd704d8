// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "core/vector.h"

namespace sherd::test {

// Crack from -a to a on the x axis in an infinite sheet, isotropic with Young's modulus 1 (source:
// Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, 1953).

using Complex = std::complex<double>;

/// sqrt(z^2 - a^2), cut between -a and a only.
inline Complex crack_root(Complex z, double a) {
    return std::sqrt(z - a) * std::sqrt(z + a);
}

/// Displacement, m, in plane stress under the remote stress (xx, yy, xy).
inline Vector2d crack_displacement(const Vector2d& at, double a, double poisson, const Vector3d& stress) {
    const Complex z(at.x(), at.y()), traction(stress[1], -stress[2]);
    const Complex uniform((stress[1] - stress[0]) / 2, -stress[2]);
    const double kappa = (3 - poisson) / (1 + poisson);
    const auto opened = [&](Complex there) { return traction / 2.0 * crack_root(there, a); };
    const Complex phi = opened(z) - uniform / 2.0 * z,
                  omega = opened(std::conj(z)) + uniform / 2.0 * std::conj(z);
    const Complex slope = traction / 2.0 * z / crack_root(z, a) - uniform / 2.0;
    const Complex u = (1 + poisson) * (kappa * phi - omega - (z - std::conj(z)) * std::conj(slope));
    return {u.real(), u.imag()};
}

/// Deflection, m, of a Kirchhoff plate with the remote curvature (xx, yy, xy), 1/m.
inline double crack_deflection(const Vector2d& at, double a, double poisson, const Vector3d& curvature) {
    const Complex z(at.x(), at.y()), root = crack_root(z, a);
    const double kappa = (3 + poisson) / (1 - poisson), mean = (curvature[0] + curvature[1]) / 4;
    const double jump = curvature[0] - mean * (1 + kappa), even = curvature[0] + mean * (kappa - 1);
    const Complex twist(0, curvature[2]), area = 0.5 * (z * root - a * a * std::log(z + root));
    const Complex phi = (even * z - jump * root) / (2 * kappa);
    const Complex of_phi = (even * z * z / 2.0 - jump * area) / (2 * kappa);
    const Complex of_omega = ((even - 2.0 * twist) * z * z / 2.0 + jump * area) / 2.0;
    return ((std::conj(z) - z) * phi + of_phi + of_omega).real();
}

/// Deflection, m, near the tip of a crack on the negative x axis, of a plate with Young's modulus 1: the
/// field of plate_field().
inline double tip_deflection(const Vector2d& at, double poisson, double thickness, double first,
                             double second) {
    const double kappa = (3 + poisson) / (1 - poisson);
    const double scale = std::sqrt(2.0) * (1 + poisson) / thickness;
    const Complex z(at.x(), at.y()), c = scale * Complex(-first, second), root = std::sqrt(z);
    return (-(std::conj(z) - z) * c / kappa * root + 2.0 / 3 * (std::conj(c) - c / kappa) * z * root).real();
}

}  // namespace sherd::test
