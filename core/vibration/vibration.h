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
    double angular_frequency() const;  ///< omega, 1/s; 0 of an unstable mode
    double frequency() const;          ///< Hz
    double growth_rate() const;        ///< 1/s; 0 of a stable mode
};

struct Vibration {
    std::vector<VibrationMode> modes;  ///< by eigenvalue, ascending; no rigid ones
    Index rigid = 0;                   ///< number of rigid motions that nothing resists
    Index freedoms = 0;  ///< coordinates that supports leave free: rigid motions and modes together
};

/// The `count` slowest modes about the shell's positions, or as many as it has: K u = omega^2 M u with the
/// exact Hessian K of elastic energies and loads, these at their full size, in the directions that pins and
/// guides leave free, and with lumped masses M. Moving supports stand where they are at time 0. Wind, damping
/// and the choice of a Jacobian have no part in it. Throws std::runtime_error when K is not finite.
Vibration vibration(const Shell& shell, const ShellEnergyOptions& options, Index count);

/// The share, 0 to 1, of a mode's kinetic energy that moves along the normals of the faces at x [3, V] m.
double share_along_normals(const Shell& shell, const Positions& x, const Positions& shape);

}  // namespace sherd
