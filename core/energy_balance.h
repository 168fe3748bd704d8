// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/reaction.h"

namespace sherd {

/// What has come into the kinetic and the potential energy of sheets and bodies, and what has gone out of it,
/// since the start of a run, J. Of a step each is computed from forces and motions in it: see EnergyLedger.
struct EnergyBalance {
    // Positive when sheets and bodies gain.
    double work_of_loads = 0;  ///< in statics weight is one of them
    double work_of_wind = 0;
    double work_of_supports = 0;   ///< of pins and clamps that move as they are told
    double work_of_obstacles = 0;  ///< of those that move as they are told

    // Positive when sheets and bodies lose.
    double lost_to_friction = 0;
    double lost_to_damping = 0;
    /// Energy stored in what carried before an edge opened and does not after, and what edges take while they
    /// open.
    double lost_to_cracks = 0;
    /// What is lost where the sheet gets other triangles, which interpolate it: of either sign.
    double lost_to_remeshing = 0;
    double lost_to_yield = 0;   ///< by bending beyond yield
    double lost_to_scheme = 0;  ///< what the time scheme takes

    double unexplained = 0;  ///< the change of the energy, less all of the above

    EnergyBalance& operator+=(const EnergyBalance& other);
    /// Enters work (J) against a force: less work of those parts that work, more loss of those that lose.
    void take(double EnergyBalance::*part, double against);
};

/// All of its members.
inline constexpr std::array balance_parts{
    &EnergyBalance::work_of_loads,     &EnergyBalance::work_of_wind,      &EnergyBalance::work_of_supports,
    &EnergyBalance::work_of_obstacles, &EnergyBalance::lost_to_friction,  &EnergyBalance::lost_to_damping,
    &EnergyBalance::lost_to_cracks,    &EnergyBalance::lost_to_remeshing, &EnergyBalance::lost_to_yield,
    &EnergyBalance::lost_to_scheme,    &EnergyBalance::unexplained};

/// Work of forces on a rigid body in its motion from one place to another, when its parts lie where they are
/// in the end. Second-order terms of the rotation are left out.
double work(const Reaction& forces, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

}  // namespace sherd
