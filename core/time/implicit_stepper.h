// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/batches/elastic_energy.h"
#include "core/contact/contact.h"
#include "core/solver/minimiser.h"
#include "core/state_visitor.h"
#include "core/time/equilibrium_path.h"
#include "core/time/inertia.h"
#include "core/time/opening_edges.h"
#include "core/time/schemes/time_scheme.h"
#include "core/time/stepper.h"

namespace sherd {

/// Each step ends at the minimum of a potential, or at an equilibrium. `position` begins a step at the
/// inertial prediction or, if contact prevents that, as near to the prediction as contact allows; a step is
/// too long if vertices or obstacles with prescribed motion cannot reach their places at its end.
class ImplicitStepper : public Stepper {
  public:
    /// The shell must outlive this object.
    ImplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start);
    ImplicitStepper(Shell& shell, const StepperOptions& options)
        : ImplicitStepper(shell, options, stepper_start(shell, options)) {}

    using Stepper::begin;
    StepResult begin(double length) override;
    StepResult solve(int max_iterations) override;
    bool solves_again() const override { return true; }
    void topology_changed(const ShellChange& change) override;
    void finish() override;

    double cohesive_share(Index edge) const override { return opening.cohesive_share(edge); }
    double dissipated_by_scheme() override;
    double load() const override { return step.load; }
    bool arrived() const override { return path && path->arrived(); }
    std::vector<Reaction> reactions() const override;
    Touch touch() const override { return contact.touch(position); }
    Positions crack_face_forces() const override { return contact.crack_face_forces(position); }
    double crack_face_overlap() const override { return contact.crack_face_overlap(position); }
    const std::vector<RigidBody>& bodies() const override { return contact.bodies(); }
    std::vector<char> crossed() const override { return contact.crossed(); }
    void visit_state(StateVisitor& visit) override;

  private:
    double stored_in_contact() const override { return contact.stored_energy(position); }
    /// Stores the unbalanced forces, and returns their increase since the last call, N, [3, V]. inserted:
    /// vertices inserted since that call.
    Positions newly_unbalanced(std::span<const IndexWithParents> inserted);
    std::vector<Energy*> all_energies();
    std::optional<std::string> overlap();
    /// Moves shell and bodies to the minimum, or to the equilibrium, without further bookkeeping.
    StepResult minimise(int max_iterations);
    StepResult minimise(int max_iterations, Positions& unknowns);
    /// Moves shell and bodies towards the prediction; returns false if vertices or obstacles with prescribed
    /// motion do not arrive.
    bool predict();
    /// Does predict() for the shell if contact stops `motion`, m, [3, V], the motion to the prediction.
    /// Vertices and obstacles with prescribed motion must arrive, so they move first, if necessary together
    /// with the vertices that obstacles push. The other vertices follow until contact stops them.
    bool predict_in_two(const Positions& motion);
    /// Fraction, 0 to 1, of a motion from the beginning of the step up to which nothing passes through a
    /// surface.
    double free_fraction(const Positions& motion);
    /// Displacement in the step, m, [3, V], by which moving obstacles push the vertices near them.
    Positions push_displacement() const;
    /// Work in the step that ends at `position`. Must be called when the bodies have ended the step and the
    /// shell has not.
    StepWork work();
    /// Adds inertia and weight to `gradient`, N, [3, V], and sets balance.lost_to_scheme.
    void add_inertia(EnergyBalance& balance, Positions& gradient) const;

    StepContext step;  ///< the open step, or the last one
    std::unique_ptr<TimeScheme> scheme;
    Inertia inertia;
    std::vector<Energy*> loads;  ///< ShellEnergies::loads()
    Threads threads;
    ElasticEnergy elastic;
    Contact contact;
    BodyInertia body_inertia;
    OpeningEdges opening{OpeningEdges::Fading::by_time};
    Potential potential;
    std::unique_ptr<Minimiser> minimiser;
    std::optional<EquilibriumPath> path;  ///< used instead of the minimiser, if there is one
    /// Forces over mass, N/kg, [3, V], that changes of the shell since the last solution have left
    /// unbalanced; no columns: no changes.
    Positions unbalanced;
};

}  // namespace sherd
