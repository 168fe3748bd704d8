// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/contact/explicit/explicit_contact.h"
#include "core/state_visitor.h"
#include "core/time/opening_edges.h"
#include "core/time/stepper.h"

namespace sherd {

/// Central differences with lumped masses (velocity Verlet). A step consists of as many substeps as stability
/// asks for: the highest frequency is estimated when the run begins and when cracks have opened or strains
/// have grown, and that of contact is bounded at the beginning of each step. Forces that depend on the
/// velocity take that of the middle of the substep. Stiffness-proportional damping is the change of the
/// elastic forces over a substep times the coefficient over its length.
class ExplicitStepper : public Stepper {
  public:
    /// The shell must outlive this object.
    ExplicitStepper(Shell& shell, const StepperOptions& options);

    using Stepper::begin;
    bool begin(double length) override;
    /// Makes the whole step, once; its iterations are substeps.
    MinimiserResult solve(int max_iterations) override;
    bool solves_again() const override { return false; }
    double held(Index edge) const override { return opening.held(edge); }
    void topology_changed(const ShellChange& change) override;
    void finish() override;

    std::vector<Reaction> reactions() const override;
    Touch touch() const override { return contact.touch(position); }
    Positions lip_forces() const override { return contact.lip_forces(position); }
    double lip_overlap() const override { return contact.lip_overlap(position); }
    const std::vector<RigidBody>& bodies() const override { return contact.of_bodies().bodies(); }

    void visit_state(StateVisitor& visit) override;
    double substep() const { return length; }  ///< s, of the open step, or of the last one

  private:
    /// Forces on the shell, N, [3, V] each; outer: of loads, wind and damping by the medium, one each.
    struct Forces {
        Positions elastic, damping, opening;
        std::vector<Positions> outer;
        ContactForces contact;

        Positions sum() const;
        void visit_state(StateVisitor& visit) {
            auto& [elastic, damping, opening, outer, contact] = *this;
            visit(elastic, damping, opening, outer, contact);
        }
    };
    double stored_in_contact() const override { return contact.stored_energy(position); }
    PotentialEnergies elastic_energies() const override;
    void choose_substep();
    /// At `position`; velocity: that of the middle of a substep.
    Forces forces_at(const Positions& velocity);
    /// Takes forces and acceleration anew, at `position`.
    void feel();
    void accelerate();
    void make_substep(double from);
    /// Moves the shell by a substep and returns the displacement.
    Positions move(double end);
    void enter(const Forces& before, const Positions& moved);

    /// What must be added to the present forces for vertices to have accelerations as `before` (m/s^2): N.
    Positions kept_forces(const Positions& before) const;

    ExplicitContact contact;
    OpeningEdges opening;
    std::vector<Energy*> elastic;
    StepContext step;                  ///< the open one, or the last one
    double time = 0;                   ///< s, end of the finished steps
    double of_shell = 0;               ///< rad/s, highest frequency without contact
    int substeps = 0;                  ///< of the open step, or of the last one
    double length = 0;                 ///< s, of each of them
    bool first = true;                 ///< whether no step has begun yet
    bool made = false;                 ///< whether the open step has been made
    bool changed = true;               ///< whether the shell has changed since the frequency was estimated
    double strain_then = 0;            ///< largest of all faces then
    Positions mode;                    ///< of the highest frequency
    Positions velocity, acceleration;  ///< m/s, m/s^2, at `position`
    Forces forces_now;
    /// Energies at `position`; none: they have not been asked for since the shell has moved or changed.
    mutable std::optional<PotentialEnergies> energies_now;
    StepWork work;            ///< of the open step
    double inertia_work = 0;  ///< J, of the forces on vertices that are not told where to be
};

}  // namespace sherd
