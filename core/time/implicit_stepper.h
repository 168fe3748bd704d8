// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/contact.h"
#include "core/forces/shell_energies.h"
#include "core/solver/newton.h"
#include "core/time/inertia.h"
#include "core/time/time_scheme.h"

namespace sherd {

struct StepperOptions {
    double step = 1e-4;             ///< s
    Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    double tolerance = 1e-9;        ///< m, largest coordinate of the last correction of the minimiser
    ShellEnergyOptions shell = {};
    ContactOptions contact = {};
};

/// Potential energies, J.
struct PotentialEnergies {
    double bending = 0, membrane = 0, gravity = 0, contact = 0;
};

/// Takes a shell from one time to the next: each step ends at the minimum of a potential. Between begin() and
/// finish() the step is open: it can be solved, the shell changed, and the step solved again.
class ImplicitStepper {
  public:
    /// The sheet must outlive it.
    ImplicitStepper(Sheet& sheet, const StepperOptions& options);

    /// Starts a step of StepperOptions::step, or of `length` s, from the sheet's positions and velocities;
    /// `position` is the inertial prediction, or as much of the way there as is free. A step that is open is
    /// given up. Returns whether what motions carry can get where it has to be; if not, the step is too long.
    /// Throws std::runtime_error if sheets overlap.
    bool begin() { return begin(options.step); }
    bool begin(double length);
    /// Advances `position` towards the minimum by at most `max_iterations` of the minimiser.
    MinimiserResult solve(int max_iterations);
    /// To be called when the sheet has other vertices, hinges or lips. Vertices that were born are put where
    /// their parents are.
    void topology_changed(const ShellChange& change);
    /// Ends the step: the sheet's positions become `position`, its velocities what the time scheme says.
    void finish();

    PotentialEnergies energies() const;                                   ///< of `position`
    Touch touch() const { return contact.touch(position); }               ///< of obstacles and bodies
    double lip_overlap() const { return contact.lip_overlap(position); }  ///< m
    /// At the end of the last finished step.
    const std::vector<RigidBody>& bodies() const { return contact.bodies(); }
    /// Where all of the step is booked; who works on it in between may book there, too.
    TimeSpent& time_spent() { return spent; }
    const TimeSpent& time_spent() const { return spent; }

    Positions position;  ///< [3, V] m, at the end of the open step

  private:
    std::vector<Energy*> all_energies();
    void require_apart();
    /// Moves `position` towards the prediction; false if what has to arrive cannot.
    bool predict();
    /// Fraction of a motion from the beginning of the step on that leads through nothing.
    double free_way(const Positions& motion);
    /// What motions and moving obstacles carry along in the step, m, [3, V].
    Positions pushed_along() const;

    TimeSpent spent;
    Sheet& sheet;
    StepperOptions options;
    double time = 0;   ///< s, up to which steps are finished
    StepContext step;  ///< the open one, or the last one
    std::unique_ptr<TimeScheme> scheme;
    Inertia inertia;
    ShellEnergies shell;
    Contact contact;
    Potential potential;
    std::unique_ptr<Minimiser> minimiser;
};

}  // namespace sherd
