// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/contact.h"
#include "core/forces/shell_energies.h"
#include "core/solver/newton.h"
#include "core/time/energy_ledger.h"
#include "core/time/equilibrium_path.h"
#include "core/time/inertia.h"
#include "core/time/time_scheme.h"

namespace sherd {

enum class Scheme { implicit_euler, statics };

struct StepperOptions {
    Scheme scheme = Scheme::implicit_euler;
    double step = 1e-4;             ///< s; in statics, of load factor
    Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    double tolerance = 1e-9;        ///< m, largest coordinate of the minimiser's last correction
    Index supports = 0;             ///< number of pins, clamps and symmetry planes in Shell::holds
    /// In statics: find the load factor, too, and end at last_load (EquilibriumPath). Else the load factor is
    /// the time.
    bool arc_length = false;
    double last_load = 1;
    ShellEnergyOptions shell = {};
    ContactOptions contact = {};
};

/// Potential energies, J.
struct PotentialEnergies {
    double bending = 0, membrane = 0, gravity = 0, contact = 0;
};

/// Advances a shell in time, or in load: each step ends at the minimum of a potential, or at an equilibrium.
/// Between begin() and finish() the step is open: it can be solved, the shell changed, and the step solved
/// again.
class ImplicitStepper {
  public:
    /// The shell must outlive this object.
    ImplicitStepper(Shell& shell, const StepperOptions& options);

    /// Starts a step of StepperOptions::step, or of `length` s, from the shell's positions and velocities.
    /// `position` becomes the inertial prediction, or the part of the way there that is free of contact. An
    /// open step is discarded. Returns false if scripted vertices or obstacles cannot reach their places at
    /// the end of the step: then the step is too long. Throws std::runtime_error if sheets overlap.
    bool begin() { return begin(options.step); }
    bool begin(double length);
    /// Advances `position` towards the minimum by at most `max_iterations` iterations.
    MinimiserResult solve(int max_iterations);
    /// Must be called when the shell has other vertices, hinges or lips. New vertices are placed where their
    /// parents are.
    void topology_changed(const ShellChange& change);
    /// Ends the step: the shell gets `position` as positions, and the velocities of the time scheme.
    void finish();

    /// The factor of all loads in the open step, or in the last one: 1, but in statics.
    double load() const { return step.load; }
    /// Whether an equilibrium path has arrived at StepperOptions::last_load.
    bool arrived() const { return path && path->arrived(); }
    PotentialEnergies energies() const;                                ///< at `position`
    const EnergyBalance& balance() const { return ledger.balance(); }  ///< of the finished steps
    /// Those of ShellEnergies at `position`.
    std::optional<Eigen::Matrix3Xd> coupled_curvatures() const { return forces.coupled_curvatures(position); }
    Eigen::Matrix3Xd face_curvatures() const { return forces.face_curvatures(position); }
    Eigen::Matrix3Xd face_strains() const { return forces.face_strains(position); }
    /// Those of the supports, then those of the obstacles, at `position` in the open step. A support's force
    /// on a vertex is mass times acceleration less all other forces, in the directions in which it holds the
    /// vertex; clamps and symmetry planes exert the forces of their mirror hinges, too.
    std::vector<Reaction> reactions() const;
    Touch touch() const { return contact.touch(position); }               ///< with obstacles and bodies
    double lip_overlap() const { return contact.lip_overlap(position); }  ///< m
    /// The bodies at the end of the last finished step.
    const std::vector<RigidBody>& bodies() const { return contact.bodies(); }
    /// Where the computing time of the step is booked; callers may book theirs on it, too.
    TimeSpent& time_spent() { return spent; }
    const TimeSpent& time_spent() const { return spent; }

    Positions position;  ///< [3, V] m, at the end of the open step

  private:
    std::vector<Energy*> all_energies();
    void require_apart();
    /// Moves `position` towards the prediction; returns false if scripted vertices or obstacles do not
    /// arrive.
    bool predict();
    /// Fraction, 0 to 1, of a motion from the beginning of the step that passes through nothing.
    double free_way(const Positions& motion);
    /// Displacement in the step, m, [3, V], by which moving obstacles push the vertices near them.
    Positions pushed_along() const;

    mutable TimeSpent spent;  // of questions, too
    Shell& shell;
    StepperOptions options;
    double time = 0;   ///< s, end of the finished steps
    StepContext step;  ///< the open step, or the last one
    std::unique_ptr<TimeScheme> scheme;
    Inertia inertia;
    ShellEnergies forces;
    std::vector<Energy*> loads;  ///< of `forces`
    Contact contact;
    EnergyLedger ledger;
    Potential potential;
    std::unique_ptr<Minimiser> minimiser;
    std::optional<EquilibriumPath> path;  ///< instead of the minimiser
};

}  // namespace sherd
