// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/batches/elastic_gradient.h"
#include "core/contact/explicit/explicit_contact.h"
#include "core/state_visitor.h"
#include "core/time/frequency_bounds.h"
#include "core/time/local_steps.h"
#include "core/time/opening_edges.h"
#include "core/time/stepper.h"

namespace sherd {

/// Central differences with lumped masses (velocity Verlet). A step consists of substeps that stability
/// permits. In a sheet that has not changed since the start, a few vertices that vibrate faster than the
/// others have levels (LocalSteps) and do not make substeps shorter. Vertices that may touch something follow
/// the forces of contact in parts of a substep, in which they move with their velocities; all other forces
/// act on them at the beginning and the end of the substep (an impulse method: Tuckerman, Berne, Martyna
/// 1992). Bounds on frequencies are computed when the run begins and when cracks have opened or strains have
/// grown, and those of contact at the beginning of each step. Forces that depend on the velocity take the
/// velocity in the middle of the substep, or of its part. Stiffness-proportional damping is the change of the
/// elastic forces over a substep, times the damping coefficient, divided by its length.
class ExplicitStepper : public Stepper {
  public:
    /// The shell must outlive this object.
    ExplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start);
    ExplicitStepper(Shell& shell, const StepperOptions& options)
        : ExplicitStepper(shell, options, stepper_start(shell, options)) {}

    using Stepper::begin;
    StepResult begin(double length) override;
    /// Makes the whole step, and repeats it with stiffer contact if surfaces would pass through each other.
    /// The iterations of the result are the parts of all substeps.
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
        return parts > 1 ? std::nullopt : bounds.fastest_triangle();
    }

    void visit_state(StateVisitor& visit) override;
    double substep() const { return length; }  ///< s, of the open or last step

  private:
    /// Forces without contact, N, [3, V] each, which act at the beginning and the end of a substep.
    struct Forces {
        Positions elastic;
        Positions damping;             ///< proportional to stiffness; without columns if there is none
        Positions opening;             ///< cohesive forces; without columns if no edge opens
        std::vector<Positions> outer;  ///< forces of each of ShellEnergies::outer(): loads, wind, and damping
                                       ///< by the medium

        Vector3d on(Index vertex) const;  ///< sum
        void visit_state(StateVisitor& visit) {
            auto& [elastic, damping, opening, outer] = *this;
            visit(elastic, damping, opening, outer);
        }
    };
    // The functions that make the open step throw std::runtime_error if it cannot continue, and return the
    // number of parts of substeps made; open() may throw, too.
    void open(double length);
    int make_open_step();
    int make_step();        ///< makes the open step
    int make_step_again();  ///< repeats the open step with stiffer contact
    void discard() override;
    double stored_in_contact() const override { return contact.stored_energy(position); }
    PotentialEnergies elastic_energies() const override;
    /// Sets `energies_now` after elastic forces have been found at `position`.
    void update_energies();
    /// Calls range(begin, end) for ranges that together contain all vertices, in several threads.
    template <class Range>
    void share_vertices(const Range& range) const;
    /// Forces, N, that must be added to the present ones so that vertices have the accelerations `before`
    /// (m/s^2).
    Positions balancing_forces(const Positions& before) const;
    /// Copies masses, gravity and guides of the shell as it is.
    void measure_vertices();

    // Lengths of substeps:

    /// Chooses substeps, levels and parts. Returns whether elastic forces must be computed again.
    bool choose_substeps();
    bool update_bounds();  ///< returns whether bounds are new
    bool choose_levels();  ///< returns whether they have changed
    ContactRates look_ahead();
    /// Number of substeps that elasticity and contact need together.
    int substeps_with(const ContactRates& rates) const;
    /// A share of the longest stable substep, s.
    double stable(double squared_frequency, double share) const;

    // Forces at `position`:

    /// Updates all forces and accelerations.
    void update_forces();
    void update_elastic_forces();
    void find_outer_forces();  ///< and cohesive forces
    void find_elastic_forces();
    void find_contact_forces(double length_of_part);
    void accelerate();
    void accelerate_in_contact();
    Positions accelerations() const;  ///< m/s^2, [3, V], by all forces

    // Motion:

    void make_substep(double from);
    void make_part(double from, double length_of_part);
    /// Change velocities by the forces of half a substep, and by those of contact in half a part.
    void kick();
    void kick_in_contact(double length_of_part);
    /// Gives vertices with a prescribed motion that moved by `way`, [3, V] m, in `duration` s their velocity.
    /// touching: whether only vertices that may touch something, or only the others.
    void follow_script(bool touching, const Positions& way, double duration);

    // Work:

    void enter_work();
    void enter_contact_work();
    /// Work against forces, J, that are `before` and `now`, N, [3, V], in the open substep.
    double taken(const Positions& before, const Positions& now) const;
    /// Work in the open step, bodies included; the step must have been made.
    StepWork all_work() const;

    Threads threads;
    ElasticGradient elastic_gradient;
    LocalSteps local_steps;
    ExplicitContact contact;
    OpeningEdges opening{OpeningEdges::Fading::by_work};
    std::vector<Energy*> elastic;
    StepContext step;             ///< the open step, or the last one
    FrequencyBounds bounds;       ///< bounds on frequencies of elasticity
    double strain_at_bounds = 0;  ///< largest strain of all faces when `bounds` were computed
    double divided = 0;           ///< s, length of the step for which levels were chosen
    /// Whether levels may differ from 0. Vibrations faster than substeps change their energy when levels or
    /// substeps change: levels end when the shell first changes, or contact first needs shorter substeps.
    bool allows_levels = true;
    int elastic_substeps = 1;  ///< number of substeps that elasticity alone needs
    int substeps = 0;          ///< number of substeps in the open step, or in the last one
    int parts = 1;             ///< number of parts of a substep
    double length = 0;         ///< s, length of a substep
    bool first = true;         ///< whether no step has begun yet
    bool made = false;         ///< whether the open step has been made, in full or in part
    bool changed = true;       ///< whether the shell has changed since `bounds` were computed
    Positions velocity;        ///< [3, V] m/s
    Positions acceleration;    ///< [3, V] m/s^2, at `position`, without contact
    /// [3, V] m/s^2, by contact; only the columns of ExplicitContact::vertices() are defined.
    Positions contact_acceleration;
    Forces forces_now;
    ContactForces contact_now;
    // Copies of the shell's data, [3, V]: masses, kg; inverse masses, 1/kg, and gravity, m/s^2, both zero for
    // fixed vertices; and the guided vertices, ascending.
    Positions mass, inverse_mass, gravity;
    std::vector<Index> guided;
    // Displacements in the open substep and in its open part, m, [3, V], and the state at their beginning.
    // They are members to save allocations.
    Positions moved, moved_in_part, acceleration_before, contact_acceleration_before;
    Forces forces_before;
    ContactForces contact_before;
    /// Energies at `position`; none: not computed since the shell has moved or changed.
    mutable std::optional<PotentialEnergies> energies_now;
    StepWork work;            ///< work in the open step
    double inertia_work = 0;  ///< J, work of mass times acceleration of the vertices that are not fixed
};

}  // namespace sherd
