// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/reaction.h"

namespace sherd {

/// Gains and losses of the kinetic and the potential energy of sheets and bodies since the start of a run, J.
/// EnergyLedger computes the gains and losses in a step from the forces and the motions in it.
struct EnergyBalance {
    // Positive when sheets and bodies gain energy.
    double work_of_loads = 0;  ///< work of loads; in statics weight is a load
    double work_of_wind = 0;
    double work_of_supports = 0;   ///< work of pins and clamps with a prescribed motion
    double work_of_obstacles = 0;  ///< work of obstacles with a prescribed motion

    // Positive when sheets and bodies lose energy.
    double lost_to_friction = 0;
    double lost_to_damping = 0;
    /// Stored energy that is lost at once when an edge opens, and energy that edges dissipate while they
    /// open.
    double lost_to_cracks = 0;
    /// Energy lost by interpolation where triangles are replaced; it may be negative.
    double lost_to_remeshing = 0;
    double lost_to_yield = 0;   ///< dissipation by bending beyond yield
    double lost_to_scheme = 0;  ///< dissipation by the time scheme

    double unexplained = 0;  ///< change of the energy that the gains and losses above do not explain

    EnergyBalance& operator+=(const EnergyBalance& other);
    /// Enters work, J, against a force: `part` decreases by `against` if it is a work, and increases if it is
    /// a loss.
    void take(double EnergyBalance::*part, double against);
};

/// All members of EnergyBalance.
inline constexpr std::array balance_parts{
    &EnergyBalance::work_of_loads,     &EnergyBalance::work_of_wind,      &EnergyBalance::work_of_supports,
    &EnergyBalance::work_of_obstacles, &EnergyBalance::lost_to_friction,  &EnergyBalance::lost_to_damping,
    &EnergyBalance::lost_to_cracks,    &EnergyBalance::lost_to_remeshing, &EnergyBalance::lost_to_yield,
    &EnergyBalance::lost_to_scheme,    &EnergyBalance::unexplained};

/// Returns the work, J, of `forces` on a rigid body that moves from the pose `from` to the pose `to`. The
/// points at which the forces act are taken at the end of the motion. Second-order terms of the rotation are
/// left out.
double work(const Reaction& forces, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

}  // namespace sherd
