// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "core/time/stepper.h"
#include "fracture/record/snapshot.h"
#include "fracture/step/breaker.h"
#include "fracture/step/interventions.h"
#include "fracture/step/simulation_options.h"
#include "fracture/step/step_policy.h"
#include "fracture/step/step_report.h"

namespace sherd {

/// Sheets that move, bend and break.
class Simulation {
  public:
    /// sheets: all sheets, in their state at the start.
    Simulation(BreakableShell sheets, const SimulationOptions& options);
    /// inputs: for at least one sheet.
    Simulation(const std::vector<SheetInput>& inputs, const SimulationOptions& options)
        : Simulation(BreakableShell(inputs), options) {}
    Simulation(const Simulation&) = delete;  // the stepper refers to the shell

    /// Advances by one time step: solves it, compares the hinges with their strengths, breaks the most
    /// overloaded ones and solves the same step again until no hinge is overloaded (or, by the paper's rule,
    /// breaks all overloaded hinges at the end). A step that cannot be solved is halved, or made with the
    /// other scheme (StepPolicy); hinges that broke in it stay broken, since they failed in a solution.
    /// Throws Error (run) when the smallest step cannot be solved.
    StepReport step();

    Snapshot snapshot() const { return snapshot(options.fields); }
    Snapshot snapshot(const FaceFieldChoice& fields) const;

    // Interventions between two steps. visit_state() does not store prescribed motions.

    /// Makes `forces`, [3, V] N, act on the vertices from the next step on, until other forces are given: see
    /// GivenForces. Throws Error unless ShellEnergyOptions::given_forces is set and there is one force for
    /// each vertex.
    void give_forces(const Positions& forces) {
        require_forces(options.stepper.shell, breakable.mechanics(), forces);
        stepper->give_forces(forces);
    }
    /// Moves vertices that pins hold in all directions, straight and at constant speed, to `positions` [3, n]
    /// m, where they arrive at `then` (s) and stay. Throws Error if no pin holds a vertex in all directions,
    /// or if `then` is not later than time().
    void prescribe(std::span<const Index> vertices, const Positions& positions, double then) {
        sherd::prescribe(breakable.mechanics(), scripts, vertices, positions, time(), then);
    }
    /// Makes the hinges of edges fail, whatever their strength, and opens the mesh. Events have the number of
    /// the last step. Throws Error if an edge has no hinge or is given twice, or if no step can begin at the
    /// present state.
    void break_by_hand(std::span<const Edge> edges);

    const BreakableShell& shell() const { return breakable; }
    const std::vector<Obstacle>& obstacles() const { return options.stepper.contact.obstacles; }
    const std::vector<RigidBody>& bodies() const { return stepper->bodies(); }
    const std::vector<Gauge>& gauges() const { return breaker.gauges(); }
    const HingePeaks& peaks() const { return breaker.peaks(); }
    /// Number of edges that ArtDirection::smallest has kept from failing.
    Index prevented_failures() const { return breaker.prevented_failures(); }
    /// Number of edges that have failed by toughness, nucleation included.
    Index grown_edges() const { return breaker.grown_edges(); }
    /// [O] 1 for obstacles, and [B] 1 for bodies, that were in contact at the end of any step so far.
    const std::vector<char>& touched_obstacles() const { return obstacles_touched; }
    const std::vector<char>& touched_bodies() const { return bodies_touched; }
    /// Returns the crack events since the last call.
    CrackEvents take_events() { return breaker.take_events(); }
    double time() const { return policy.time(); }  ///< s, end of the last step; in statics load factor
    /// Whether the run has ended: see SimulationOptions::until_crack and Stepper::arrived().
    bool arrived() const { return ends_at_crack || stepper->arrived(); }
    /// The wall time of all steps by task.
    const TimeSpent& time_spent() const { return stepper->time_spent(); }
    /// Visits all state that a simulation of the same input needs to continue from here bit for bit.
    void visit_state(StateVisitor& visit);

  private:
    /// Records the measures and peaks of a solution. Returns the reason for another attempt at the step, for
    /// example with explicit steps; Urgency::none if there is none.
    Urgency evaluate(const Measured& now, StepReport& report);
    Urgency urgency_after(const Measured& now, const StepReport& report);
    /// Breaks edges and solves the step again until no hinge is overloaded. Returns the result of the last
    /// solution.
    Attempt break_in_stages(Measured now, StepReport& report);
    void break_at_once(const Measured& now, StepReport& report);
    BreakingStage this_stage(const StepReport& report, double waited = 0) const {
        return {report.step, time(), time() + policy.size(), report.stages, waited};
    }
    /// Replaces the stepper by a stepper of the scheme that the policy has chosen.
    void take_scheme();
    bool is_static() const { return options.stepper.scheme == Scheme::statics; }
    std::string where() const;                       ///< step and time, for messages
    std::string failure(const Attempt& last) const;  ///< message if no other attempt is left
    /// Re-enables contact between crack faces, and between elements that overlapped at the start, if they
    /// have separated at the present positions. bodies: the bodies at their present places. Returns whether
    /// contact has been re-enabled anywhere.
    bool release_apart(const std::vector<RigidBody>& bodies);
    void enable_contact();
    void report_state(StepReport& report);
    void report_energies(StepReport& report) const;
    void report_touch(StepReport& report);
    void report_gauges(StepReport& report) const;

    const SimulationOptions options;
    std::int64_t steps = 0;
    BreakableShell breakable;
    Breaker breaker;
    StepPolicy policy;
    std::unique_ptr<Stepper> stepper;
    SchemeChoice taken;  ///< scheme of the stepper
    std::vector<char> obstacles_touched, bodies_touched;
    bool ends_at_crack = false;
    const std::size_t scripts;  ///< number of prescribed motions at the start
};

}  // namespace sherd
