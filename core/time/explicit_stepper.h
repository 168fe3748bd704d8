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
/// requires: the highest frequency is estimated when the run begins and when cracks have opened or strains
/// have grown, and the frequency of contact is bounded at the beginning of each step. Forces that depend on
/// the velocity take the velocity in the middle of the substep. Stiffness-proportional damping is the change
/// of the elastic forces over a substep, times the damping coefficient, divided by the substep's length.
class ExplicitStepper : public Stepper {
  public:
    /// The shell must outlive this object.
    ExplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start);
    ExplicitStepper(Shell& shell, const StepperOptions& options)
        : ExplicitStepper(shell, options, stepper_start(shell, options)) {}

    using Stepper::begin;
    StepResult begin(double length) override;
    /// Makes the whole step, and repeats it with stiffer contact if surfaces would pass through each other.
    /// The iterations of the result are substeps.
    StepResult solve(int max_iterations) override;
    bool solves_again() const override { return false; }
    double cohesive_share(Index edge) const override { return opening.cohesive_share(edge); }
    double dissipated_by_scheme() override { return ledger.dissipated_by_scheme(all_work(), stored()); }
    void topology_changed(const ShellChange& change) override;
    void finish() override;

    std::vector<Reaction> reactions() const override;
    Touch touch() const override { return contact.touch(position); }
    Positions crack_face_forces() const override { return contact.crack_face_forces(position); }
    double crack_face_overlap() const override { return contact.crack_face_overlap(position); }
    const std::vector<RigidBody>& bodies() const override { return contact.of_bodies().bodies(); }
    std::vector<char> crossed() const override { return contact.of_bodies().crossed(); }
    std::optional<Index> fastest_triangle() const override {
        if (contact_frequency > shell_frequency || mode.cols() == 0) return std::nullopt;
        return sherd::fastest_triangle(shell, mode);
    }

    void visit_state(StateVisitor& visit) override;
    double substep() const { return length; }  ///< s, of the open or last step

  private:
    /// Forces on the shell, N, [3, V] each. damping: stiffness-proportional; opening: cohesive forces of
    /// opening edges; both have no columns if there are no such forces. outer: one entry for each of
    /// ShellEnergies::outer(): loads, wind, and damping by the medium.
    struct Forces {
        Positions elastic, damping, opening;
        std::vector<Positions> outer;
        ContactForces contact;

        Vector3d on(Index vertex) const;  ///< sum of all forces
        Positions sum() const;
        void visit_state(StateVisitor& visit) {
            auto& [elastic, damping, opening, outer, contact] = *this;
            visit(elastic, damping, opening, outer, contact);
        }
    };
    // The functions that make the open step throw std::runtime_error if it cannot continue, and return the
    // number of substeps made; open() may throw, too.
    void open(double length);
    int make_open_step();
    void discard() override;
    double stored_in_contact() const override { return contact.stored_energy(position); }
    PotentialEnergies elastic_energies() const override;
    void choose_substep();
    /// Copies masses, gravity and guides of the shell as it is.
    void measure_vertices();
    /// Work in a substep, J.
    struct Work {
        double against_stored = 0, of_inertia = 0, lost_to_friction = 0;
    };
    /// Calls range(begin, end) for ranges that together contain all vertices, in several threads.
    template <class Range>
    void share_vertices(const Range& range) const;
    /// Computes the forces at `position` except elastic forces and their damping: of the elastic forces only
    /// the gradient in `elastic_gradient`. Forces that depend on the velocity take the present `velocity`,
    /// which belongs to the middle of a substep.
    void find_forces();
    /// Updates forces and accelerations at `position`.
    void update_forces();
    void accelerate() { accelerate(0, static_cast<Index>(position.cols())); }
    void accelerate(Index begin, Index end);
    void make_substep(double from);
    /// Makes the open step; returns how many substeps that took.
    int make_step();
    int make_step_again();  ///< repeats the open step with stiffer contact
    /// Makes the first half of the kick (change of the velocities), and moves the vertices.
    void move(double end);
    /// Moves vertices with a prescribed motion to their places at the time `end` (s), and corrects `moved`.
    void move_scripted(double end);
    /// Computes the elastic forces, and makes the second half of the kick.
    Work kick();
    /// Work against forces in the open substep, J. before, now: forces at its beginning and end, N, [3, V].
    double taken(const Positions& before, const Positions& now) const;
    void enter(const Work& of_substep);
    /// Work in the open step, bodies included; the step must have been made.
    StepWork all_work() const;

    /// Forces, N, that must be added to the present ones so that vertices have the accelerations `before`
    /// (m/s^2).
    Positions balancing_forces(const Positions& before) const;

    Threads threads;
    ElasticGradient elastic_gradient;
    ExplicitContact contact;
    OpeningEdges opening{OpeningEdges::Fading::by_work};
    std::vector<Energy*> elastic;
    StepContext step;                  ///< the open step, or the last one
    double shell_frequency = 0;        ///< rad/s, highest frequency without contact
    double contact_frequency = 0;      ///< rad/s, bound on the frequency of contact alone
    int substeps = 0;                  ///< number of substeps in the open step, or in the last one
    double length = 0;                 ///< s, length of a substep
    bool first = true;                 ///< whether no step has begun yet
    bool made = false;                 ///< whether the open step has been made, in full or in part
    bool changed = true;               ///< whether the shell has changed since the frequency was estimated
    double strain_at_estimate = 0;     ///< largest strain of all faces at that estimate
    Positions mode;                    ///< [3, V] mode of the highest frequency
    Positions velocity, acceleration;  ///< [3, V] m/s; [3, V] m/s^2, at `position`
    Forces forces_now;
    // Copies of the shell's data, [3, V]: masses, kg; inverse masses, 1/kg, and gravity, m/s^2, both zero for
    // fixed vertices; and the guided vertices, ascending.
    Positions mass, inverse_mass, gravity;
    std::vector<Index> guided;
    // Displacements in the open substep, m, [3, V], and the state at its beginning. They are members to save
    // allocations.
    Positions moved, acceleration_before;
    Forces forces_before;
    /// Energies at `position`; none: not computed since the shell has moved or changed.
    mutable std::optional<PotentialEnergies> energies_now;
    StepWork work;            ///< work in the open step
    double inertia_work = 0;  ///< J, work of mass times acceleration of the vertices that are not fixed
};

}  // namespace sherd
