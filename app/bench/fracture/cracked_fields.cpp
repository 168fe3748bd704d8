// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/fracture/cracked_fields.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace sherd {
namespace {

using Complex = std::complex<double>;

/// sqrt(z^2 - a^2), with a branch cut between -a and a only.
Complex cut_root(Complex z, double a) {
    return std::sqrt(z - a) * std::sqrt(z + a);
}

}  // namespace

PulledSheet::PulledSheet(double half_length, double angle) : half_length(half_length), angle(angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    across = c * c;
    along = s * s;
    shear_stress = s * c;
    traction = {across, -shear_stress};
}

double PulledSheet::opening() const {
    return across * std::sqrt(std::numbers::pi * half_length);
}

double PulledSheet::shear() const {
    return std::abs(shear_stress) * std::sqrt(std::numbers::pi * half_length);
}

// In the crack's frame s_xx + s_yy = 4 Re Phi(z) and
// s_yy - i s_xy = Phi(z) + Omega(conj z) + (z - conj z) conj(Phi'(z)); slope is Phi'(z).
Eigen::Matrix2d PulledSheet::stress(const Vector2d& at) const {
    const Eigen::Rotation2Dd turn(angle);
    const Vector2d p = turn.inverse() * at;
    const Complex z(p.x(), p.y()), root = cut_root(z, half_length);
    const Complex uniform((across - along) / 2, -shear_stress);
    const Complex phi = traction / 2.0 * z / root - uniform / 2.0;
    const Complex omega = traction / 2.0 * std::conj(z) / cut_root(std::conj(z), half_length) + uniform / 2.0;
    const Complex slope = -traction / 2.0 * half_length * half_length / (root * root * root);
    const Complex on_line = phi + omega + (z - std::conj(z)) * std::conj(slope);
    Eigen::Matrix2d stress;
    stress << 4 * phi.real() - on_line.real(), -on_line.imag(), -on_line.imag(), on_line.real();
    return turn.toRotationMatrix() * stress * turn.toRotationMatrix().transpose();
}

namespace {

/// The deflection of a plate of rigidity 1 with m_yy = 1 far away is w = Re((conj z - z) f + integrals of f
/// and g). The potentials f and g enter the moments with f', f'' and g'.
struct PlatePotentials {
    Complex phi, slope, omega;  ///< f', f'' and g' at z

    PlatePotentials(Complex z, double a, double poisson) {
        const double kappa = (3 + poisson) / (1 - poisson), scale = 1 / (1 - poisson * poisson);
        const double xx = poisson * scale, yy = -scale;  // curvatures far away
        const double mean = (xx + yy) / 4;
        const double jump = xx - mean * (1 + kappa), even = xx + mean * (kappa - 1);
        const Complex root = cut_root(z, a);
        phi = (even - jump * z / root) / (2 * kappa);
        slope = jump * a * a / (root * root * root) / (2 * kappa);
        omega = (even + jump * z / root) / 2.0;
    }
};

}  // namespace

Eigen::Matrix2d CrackedPlate::moments(const Vector2d& at) const {
    const Complex z(at.x(), at.y());
    const PlatePotentials of(z, half_length, poisson);
    const double sum = 4 * of.phi.real();  // sum of the curvatures
    const Complex rest =                   // w_xx - w_yy + 2 i w_xy
        2.0 * (std::conj(of.omega) - std::conj(of.phi) + (z - std::conj(z)) * std::conj(of.slope));
    Eigen::Matrix2d curvature;
    curvature << (sum + rest.real()) / 2, rest.imag() / 2, rest.imag() / 2, (sum - rest.real()) / 2;
    return -((1 - poisson) * curvature + poisson * sum * Eigen::Matrix2d::Identity());
}

Vector2d CrackedPlate::shear(const Vector2d& at) const {
    const PlatePotentials of(Complex(at.x(), at.y()), half_length, poisson);
    return -4 * Vector2d(of.slope.real(), -of.slope.imag());
}

}  // namespace sherd
