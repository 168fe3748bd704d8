// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/body_contact.h"
#include "core/contact/obstacle_contact.h"
#include "core/contact/sheet_contact.h"
#include "core/damping.h"
#include "core/loads.h"
#include "core/mirror_hinge.h"
#include "core/newton.h"
#include "core/sheet_energies.h"
#include "core/wind.h"

namespace sherd {

struct TimeStepOptions {
    double step = 1e-4;             ///< s
    Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    BendingOptions bending;         ///< energy and Jacobian of the hinges
    NewtonOptions newton;
    std::vector<Obstacle> obstacles;
    std::vector<RigidBody> bodies;  ///< at the start
    std::vector<Load> loads;
    std::vector<Wind> winds;
    std::vector<MirrorHinge> mirrors;  ///< at clamps and symmetry planes
    Damping damping;
    bool sheet_contact = false;  ///< whether sheets meet each other, and themselves
    double sheet_friction = 0;   ///< Coulomb coefficient of sheets on sheets
};

/// Potential energies of a sheet, J.
struct PotentialEnergies {
    double bending = 0, membrane = 0, gravity = 0, contact = 0;
};

/// Implicit Euler: each step ends at the minimum of the incremental potential. Between begin() and finish()
/// the step is open: it can be solved, its stencils changed, and solved again.
class TimeStep {
  public:
    /// The sheet must outlive it.
    TimeStep(Sheet& sheet, const TimeStepOptions& options);

    /// Starts a step of TimeStepOptions::step, or of `length` s, from the sheet's positions and velocities;
    /// `position` is the inertial prediction, or as much of the way there as is free. A step that is open is
    /// given up. Returns whether what motions carry can get where it has to be; if not, the step is too long.
    /// Throws std::runtime_error if sheets overlap.
    bool begin() { return begin(options.step); }
    bool begin(double length);
    /// Advances `position` towards the minimum by at most `max_iterations` of Newton's method.
    NewtonResult solve(int max_iterations);
    /// To be called when vertices were added or stencils changed. New vertices of the sheet get their
    /// position from whoever added them, in `position` and in the sheet.
    void stencils_changed();
    /// Ends the step: the sheet's positions become `position`, its velocities the difference quotient.
    void finish();

    PotentialEnergies energies() const;  ///< of `position`
    Touch touch() const;                 ///< of obstacles and bodies, at `position`
    /// At the end of the last finished step.
    const std::vector<RigidBody>& bodies() const { return moved_bodies; }
    double lip_overlap() const { return lips.largest_overlap(position); }  ///< m
    /// Where all of the step is booked; who works on it in between may book there, too.
    TimeSpent& time_spent() { return spent; }
    const TimeSpent& time_spent() const { return spent; }

    Positions position;  ///< [3, V] m, at the end of the open step

  private:
    void prepare();
    void prepare_loads();
    void prepare_contact();
    void prepare_bodies();
    void change_surface();
    void carry_mirrors();
    /// Moves `position` towards the prediction; false if what has to arrive cannot.
    bool predict();
    Positions carried(const Positions& motion) const;  ///< that of vertices that motions carry, m
    Positions taken_along(const Positions& motion);    ///< with what obstacles that move are near to

    TimeSpent spent;
    Sheet& sheet;
    TimeStepOptions options;
    double time = 0;   ///< s, up to which steps are finished
    double start = 0;  ///< s, at the beginning of the open step, or the last one
    double step;       ///< s, its length
    BendingEnergy bending;
    MembraneEnergy membrane;
    std::vector<MirrorHinge> mirror_hinges;  ///< at the end of the open step, or the last one
    MirrorEnergy mirrors;
    std::vector<std::unique_ptr<NearPairs>> body_pairs;  ///< of each body; null: it has no surface
    std::unique_ptr<BodyContact> body_contact;      ///< of the open step, or the last one; null: no bodies
    std::vector<ObstacleContact> obstacle_contact;  ///< of the open step, or the last one
    /// None if sheets are not to meet each other, and no obstacle has a surface.
    std::unique_ptr<SheetContact> sheet_contact;
    LipContact lips;
    std::vector<RigidBody> start_bodies, moved_bodies;  ///< at `start` and at `time`
    std::vector<std::unique_ptr<Energy>> of_step;       ///< that refer to its beginning: loads, wind, damping
    std::unique_ptr<IncrementalPotential> potential;
    std::unique_ptr<NewtonSystem> system;
};

}  // namespace sherd
