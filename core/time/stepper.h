// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/contact/colliders/touch.h"
#include "core/contact/contact_options.h"
#include "core/forces/shell_energies.h"
#include "core/state_visitor.h"
#include "core/time/energy_ledger.h"
#include "core/time/step_result.h"
#include "core/time_spent.h"

namespace sherd {

enum class Scheme { implicit_euler, bdf2, statics, explicit_differences };
/// Method by which an implicit step finds its minimum.
enum class Method { quasi_newton, newton };

struct StepperOptions {
    Scheme scheme = Scheme::implicit_euler;
    Method method = Method::quasi_newton;
    double step = 1e-4;             ///< s, length of a step; in statics, change of the load factor
    Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    double tolerance = 1e-9;        ///< m, largest coordinate of the minimiser's last correction
    Index supports = 0;             ///< number of pins, clamps and symmetry planes in Shell::support_sets
    /// Whether statics follow an equilibrium path with an unknown load factor, to last_load
    /// (EquilibriumPath); if not, the load factor is the time.
    bool arc_length = false;
    double last_load = 1;
    int threads = 1;  ///< largest number of threads; results do not depend on it
    ShellEnergyOptions shell = {};
    ContactOptions contact = {};
};

/// Potential energies, J.
struct PotentialEnergies {
    double bending = 0, membrane = 0, gravity = 0, contact = 0;

    double stored() const { return bending + membrane + contact; }
};

/// State of a run that does not depend on the scheme.
struct StepperStart {
    ShellEnergies forces;
    ContactStart contact;
    EnergyLedger ledger = {};
    TimeSpent spent = {};
    double time = 0;  ///< s
};

/// Advances a shell in time, or in load. Between begin() and finish() the step is open: the step can be
/// solved, the shell can be changed, and, if solves_again(), the step must then be solved again.
class Stepper {
  public:
    virtual ~Stepper() = default;
    Stepper(const Stepper&) = delete;  // the energies refer to the shell

    /// Starts a step of StepperOptions::step, or of `length` s, from the shell's positions and velocities. An
    /// open step is discarded. Outcomes besides `done` are `too_long`, and `failed`, for example if sheets
    /// overlap.
    StepResult begin() { return begin(options.step); }
    virtual StepResult begin(double length) = 0;
    /// Advances `position` towards the end of the step, by at most `max_iterations` iterations.
    virtual StepResult solve(int max_iterations) = 0;
    /// Whether a change of the shell changes the end of the open step, so that it must be solved again.
    virtual bool solves_again() const = 0;
    /// Must be called after a change of the shell's vertices, triangles, hinges or crack faces. New and moved
    /// vertices are placed where their parents are.
    virtual void topology_changed(const ShellChange& change) = 0;
    /// Sets the forces, N, [3, V], that act from the next step on: see ShellEnergies::give().
    void give_forces(const Positions& force) { forces.give(force); }
    /// Ends the step: the shell gets `position` as positions, and new velocities.
    virtual void finish() = 0;

    /// Share of the cohesive force that still acts on an edge: see ShellChange::opening.
    virtual double cohesive_share(Index /*edge*/) const { return 0; }

    /// The triangle whose vibration limits the substeps of the last step; none if contact limits them, and in
    /// schemes without substeps.
    virtual std::optional<Index> fastest_triangle() const { return std::nullopt; }

    Scheme scheme() const { return options.scheme; }
    /// Energy that the time scheme dissipates in the open step, which must have been solved, J.
    virtual double dissipated_by_scheme() = 0;
    /// Factor of all loads in the open step, or in the last one: 1, except in statics.
    virtual double load() const { return 1; }
    /// Whether an equilibrium path has arrived at StepperOptions::last_load.
    virtual bool arrived() const { return false; }
    PotentialEnergies energies() const;                                ///< at `position`
    const EnergyBalance& balance() const { return ledger.balance(); }  ///< sum over the finished steps
    /// Curvatures and strains of ShellEnergies at `position`.
    std::optional<Eigen::Matrix3Xd> coupled_curvatures() const { return forces.coupled_curvatures(position); }
    std::optional<Eigen::Matrix3Xd> plastic_curvatures() const { return forces.plastic_curvatures(position); }
    Eigen::Matrix3Xd face_curvatures() const { return forces.face_curvatures(position); }
    Eigen::Matrix3Xd face_strains() const { return forces.face_strains(position); }
    // The curvatures and strains of the given faces alone, [3, faces].
    std::optional<Eigen::Matrix3Xd> coupled_curvatures(std::span<const Index> faces) const {
        return forces.coupled_curvatures(position, faces);
    }
    std::optional<Eigen::Matrix3Xd> plastic_curvatures(std::span<const Index> faces) const {
        return forces.plastic_curvatures(position, faces);
    }
    Eigen::Matrix3Xd face_strains(std::span<const Index> faces) const {
        return forces.face_strains(position, faces);
    }
    /// Energy of coupled hinges; null if hinges are not coupled.
    const CoupledBending* coupled_bending() const { return forces.coupled_bending(); }
    /// Derivative of the elastic energy at `position`, N, [3, V].
    Positions elastic_gradient();
    virtual Positions crack_face_forces()
        const = 0;  ///< N, [3, V], contact forces of crack faces at `position`
    /// Reactions of the supports, then of the obstacles, at `position` in the open step. A support's force on
    /// a vertex is mass times acceleration less all other forces, in the directions in which it holds the
    /// vertex; clamps and symmetry planes exert the forces of their mirror hinges, too.
    virtual std::vector<Reaction> reactions() const = 0;
    virtual Touch touch() const = 0;                ///< contact with obstacles and bodies
    virtual double crack_face_overlap() const = 0;  ///< m, largest overlap of crack faces
    /// The bodies at the end of the last finished step.
    virtual const std::vector<RigidBody>& bodies() const = 0;
    /// For each of the bodies' surface pairs, whether it is exempt at the end of the last finished step: see
    /// surface_pairs().
    virtual std::vector<char> crossed() const = 0;

    virtual void visit_state(StateVisitor& visit) {
        auto& [position, spent, shell, options, forces, ledger, time] = *this;
        visit(position, forces, ledger, time);
    }

    /// Account of the computing time, to which callers may add their own.
    TimeSpent& time_spent() { return spent; }
    const TimeSpent& time_spent() const { return spent; }

    Positions position;  ///< [3, V] m, at the end of the open step

  protected:
    /// The shell must outlive this object. Takes over all members of `start` but `contact`.
    Stepper(Shell& shell, const StepperOptions& options, StepperStart& start);
    /// Reverts what an open step has changed besides `position`.
    virtual void discard() {}
    virtual double stored_in_contact() const = 0;  ///< J, elastic energy of contact at `position`
    /// Places clamps and symmetry planes where they are when the step begins.
    void place_clamps_at_start(StepContext step);
    /// Elastic energy at Shell::position, with clamps where they are when the step begins, J.
    double elastic_at_start(const StepContext& step);
    /// Energies of elasticity and contact at `position`, without gravity.
    virtual PotentialEnergies elastic_energies() const {
        return {forces.bending_value(position), forces.membrane_value(position), 0, stored_in_contact()};
    }
    double stored() const { return elastic_energies().stored(); }  ///< J
    /// Potential energy of gravity with the shell at x, J, relative to the origin; 0 in statics, where weight
    /// is a load.
    double weight(const Positions& x) const;
    /// Moving energy, J: kinetic energy of the shell at this velocity (m/s) and of the bodies, plus
    /// weight(x).
    double moving(const Positions& velocity, const Positions& x) const;

    mutable TimeSpent spent;  // mutable because const functions add their time, too
    Shell& shell;
    const StepperOptions options;
    ShellEnergies forces;
    EnergyLedger ledger;
    double time = 0;  ///< s, end of the finished steps: the sum of their lengths, with its round-off

    friend std::unique_ptr<Stepper> with_scheme(std::unique_ptr<Stepper> before, Scheme scheme,
                                                bool barriers_follow);
};

/// The state at the beginning of a run.
StepperStart stepper_start(const Shell& shell, const StepperOptions& options);
/// The stepper of the options' scheme. The shell must outlive it.
std::unique_ptr<Stepper> make_stepper(Shell& shell, const StepperOptions& options);
/// A stepper of another scheme that continues from the last finished step of `before`; an open step is
/// discarded. Cohesive forces of opening edges end. barriers_follow: see ContactOptions.
std::unique_ptr<Stepper> with_scheme(std::unique_ptr<Stepper> before, Scheme scheme,
                                     bool barriers_follow = false);

}  // namespace sherd
