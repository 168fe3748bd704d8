// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/forces/shell_energies.h"

namespace sherd {

/// A free vibration u(t) = shape sin(omega t) of small amplitude, without damping.
struct VibrationMode {
    double eigenvalue = 0;  ///< omega^2, 1/s^2; below zero: growth as exp(sqrt(-eigenvalue) t)
    Positions shape;        ///< [3, V] 1/sqrt(kg): sum of m |u|^2 is 1, the largest coordinate positive

    bool unstable() const { return eigenvalue < 0; }
    double angular_frequency() const;  ///< omega, 1/s; 0 for an unstable mode
    double frequency() const;          ///< Hz
    double growth_rate() const;        ///< 1/s; 0 for a stable mode
};

struct Vibration {
    std::vector<VibrationMode> modes;  ///< ascending by eigenvalue, without rigid motions
    Index rigid = 0;                   ///< number of rigid motions that nothing resists
    /// Number of coordinates that supports leave free: rigid motions and all modes together.
    Index freedoms = 0;
};

/// Returns the `count` slowest modes about the shell's positions, or all modes if there are fewer. They solve
/// K u = omega^2 M u in the directions that pins and guides leave free, with the exact Hessian K of elastic
/// energies and of loads at their full size, and with lumped masses M. Moving supports are at their places at
/// time 0. Wind, damping and the choice of a Jacobian have no effect. Throws std::runtime_error if K is not
/// finite, or if the search for modes does not converge.
Vibration vibration(const Shell& shell, const ShellEnergyOptions& options, Index count);

/// The share, 0 to 1, of the kinetic energy of a mode, VibrationMode::shape, that is due to motion along the
/// normals of the faces at x [3, V] m.
double share_along_normals(const Shell& shell, const Positions& x, const Positions& shape);

}  // namespace sherd
