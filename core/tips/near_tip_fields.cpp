// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/near_tip_fields.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace sherd {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

}  // namespace

// Muskhelishvili's functions, with the same Phi above and below the crack's line (a star denotes the complex
// conjugate):
//     s11 + s22 = 4 Re Phi(z),    s22 - i s12 = Phi(z) + Phi(z*) + (z - z*) Phi'(z)*
//     2 mu d(u + iv)/dx = kappa Phi(z) - Phi(z*) - (z - z*) Phi'(z)*
MembraneField membrane_field(const PlaneStress& material, const ModePair& factors, const Vector2d& at) {
    const auto [young, poisson] = material;
    const Complex z(at.x(), at.y()), factor = Complex(factors.first, -factors.second) / std::sqrt(8 * pi);
    const Complex here = factor / std::sqrt(z), mirrored = factor / std::sqrt(std::conj(z));
    const Complex third = (z - std::conj(z)) * std::conj(-0.5 * here / z);
    const Complex traction = here + mirrored + third;
    const double kappa = (3 - poisson) / (1 + poisson);
    const Complex moved = (1 + poisson) / young * (kappa * here - mirrored - third);
    MembraneField field;
    field.stress << 4 * here.real() - traction.real(), traction.real(), -traction.imag();
    field.strain << (field.stress[0] - poisson * field.stress[1]) / young,
        (field.stress[1] - poisson * field.stress[0]) / young, 2 * (1 + poisson) / young * field.stress[2];
    field.along_gradient << moved.real(), moved.imag();
    return field;
}

// The deflection is Re((z* - z) phi + int phi + int omega), in which a free edge along the crack requires
//     phi = -c / kappa z^0.5,    omega = c* z^0.5,    kappa = (3 + nu) / (1 - nu).
PlateField plate_field(const PlaneStress& material, double thickness, const ModePair& factors,
                       const Vector2d& at) {
    const auto [young, poisson] = material;
    const double kappa = (3 + poisson) / (1 - poisson);
    const double rigidity = young * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
    const double scale = thickness * thickness / (6 * std::numbers::sqrt2 * rigidity * (1 - poisson));
    const Complex c = scale * Complex(-factors.first, factors.second);
    const Complex z(at.x(), at.y()), root = std::sqrt(z), twice_y(0, 2 * at.y());
    const Complex phi = -c / kappa * root, slope = 0.5 * phi / z, bend = -0.5 * slope / z;
    const Complex omega = std::conj(c) * root, omega_slope = 0.5 * omega / z;
    // d/dx, d2/dx2, d2/dxdy and the Laplacian of the deflection; z* - z = -twice_y.
    const Complex xx = -twice_y * bend + slope + omega_slope;
    const double sum = 4 * slope.real(), first = xx.real();
    const Complex xy = Complex(0, -2) * slope + Complex(0, 1) * xx;
    PlateField field;
    field.curvature << first, sum - first, 2 * xy.real();
    field.along_slope = (-twice_y * slope + phi + omega).real();
    return field;
}

double membrane_release(const PlaneStress& material, const ModePair& factors) {
    return (factors.first * factors.first + factors.second * factors.second) / material.young;
}

double plate_release(const PlaneStress& material, const ModePair& factors) {
    const auto [young, poisson] = material;
    return pi * (1 + poisson) / (3 * young * (3 + poisson)) *
           (factors.first * factors.first + factors.second * factors.second);
}

}  // namespace sherd
