// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/batches/elastic_gradient.h"
#include "core/contact/explicit/explicit_contact.h"
#include "core/state_visitor.h"
#include "core/time/highest_frequency.h"
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
    ExplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start);
    ExplicitStepper(Shell& shell, const StepperOptions& options)
        : ExplicitStepper(shell, options, stepper_start(shell, options)) {}

    using Stepper::begin;
    bool begin(double length) override;
    /// Makes the whole step, once, or again with firmer contact where something would pass; its iterations
    /// are substeps.
    MinimiserResult solve(int max_iterations) override;
    bool solves_again() const override { return false; }
    double held(Index edge) const override { return opening.held(edge); }
    double taken_by_scheme() override { return ledger.taken_by_scheme(all_work(), stored()); }
    void topology_changed(const ShellChange& change) override;
    void finish() override;

    std::vector<Reaction> reactions() const override;
    Touch touch() const override { return contact.touch(position); }
    Positions lip_forces() const override { return contact.lip_forces(position); }
    double lip_overlap() const override { return contact.lip_overlap(position); }
    const std::vector<RigidBody>& bodies() const override { return contact.of_bodies().bodies(); }
    std::vector<char> crossed() const override { return contact.of_bodies().crossed(); }
    std::optional<Index> fastest_triangle() const override {
        if (of_contact > of_shell || mode.cols() == 0) return std::nullopt;
        return sherd::fastest_triangle(shell, mode);
    }

    void visit_state(StateVisitor& visit) override;
    double substep() const { return length; }  ///< s, of the open step, or of the last one

  private:
    /// Forces on the shell, N, [3, V] each; outer: of loads, wind and damping by the medium, one each.
    /// Damping and opening have no columns where nothing damps or opens.
    struct Forces {
        Positions elastic, damping, opening;
        std::vector<Positions> outer;
        ContactForces contact;

        Vector3d on(Index vertex) const;  ///< of all of them
        Positions sum() const;
        void visit_state(StateVisitor& visit) {
            auto& [elastic, damping, opening, outer, contact] = *this;
            visit(elastic, damping, opening, outer, contact);
        }
    };
    void discard() override;
    double stored_in_contact() const override { return contact.stored_energy(position); }
    PotentialEnergies elastic_energies() const override;
    void choose_substep();
    /// Takes masses and guides of the shell as it is.
    void measure_vertices();
    /// Work in a substep, J.
    struct Work {
        double against_stored = 0, of_inertia = 0, lost_to_friction = 0;
    };
    /// Calls range(begin, end) for ranges of vertices that together are all.
    template <class Range>
    void share_vertices(const Range& range) const;
    /// Finds all forces at `position` but those of elasticity, of which only the gradient is found. Those of
    /// the velocity take it as it is, that of the middle of a substep.
    void find_forces();
    /// Takes forces and accelerations anew, at `position`.
    void feel();
    void accelerate() { accelerate(0, static_cast<Index>(position.cols())); }
    void accelerate(Index begin, Index end);
    void make_substep(double from);
    /// Makes the open step; returns how many substeps that took.
    int make_step();
    int make_step_again();  ///< with firmer contact
    /// The first half of the kick, and the motion.
    void move(double end);
    /// Moves what is told where to be, from where `moved` has it.
    void move_scripted(double end);
    /// Takes the forces of elasticity, and makes the second half of the kick.
    Work kick();
    /// J, lost by forces that were and are, in the present motion.
    double taken(const Positions& before, const Positions& now) const;
    void enter(const Work& of_substep);
    /// That of the open step, which has been made, with the bodies'.
    StepWork all_work() const;

    /// What must be added to the present forces for vertices to have accelerations as `before` (m/s^2): N.
    Positions kept_forces(const Positions& before) const;

    Threads threads;
    ElasticGradient elastic_gradient;
    ExplicitContact contact;
    OpeningEdges opening;
    std::vector<Energy*> elastic;
    StepContext step;                  ///< the open one, or the last one
    double of_shell = 0;               ///< rad/s, highest frequency without contact
    double of_contact = 0;             ///< rad/s, bound of that of contact alone
    int substeps = 0;                  ///< of the open step, or of the last one
    double length = 0;                 ///< s, of each of them
    bool first = true;                 ///< whether no step has begun yet
    bool made = false;                 ///< whether the open step has been made, or begun to be
    bool changed = true;               ///< whether the shell has changed since the frequency was estimated
    double strain_then = 0;            ///< largest of all faces then
    Positions mode;                    ///< of the highest frequency
    Positions velocity, acceleration;  ///< m/s, m/s^2, at `position`
    Forces forces_now;
    // Of the shell as it is, [3, V]: masses, kg, and of what is not held one over them and gravity; and what
    // slides along guides.
    Positions mass, of_mass, gravity;
    std::vector<Index> guided;
    // Of the open substep, kept to save allocations: m, [3, V], and what was at its beginning.
    Positions moved, acceleration_before;
    Forces forces_before;
    /// Energies at `position`; none: they have not been asked for since the shell has moved or changed.
    mutable std::optional<PotentialEnergies> energies_now;
    StepWork work;            ///< of the open step
    double inertia_work = 0;  ///< J, of the forces on vertices that are not told where to be
};

}  // namespace sherd
