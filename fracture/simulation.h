// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "core/time/stepper.h"
#include "fracture/breaking.h"
#include "fracture/crack_growth.h"
#include "fracture/events.h"
#include "fracture/fragments.h"
#include "fracture/gauge.h"
#include "fracture/hinge_peaks.h"
#include "fracture/snapshot.h"
#include "fracture/step_pace.h"
#include "fracture/step_report.h"
#include "fracture/step_size.h"

namespace sherd {

/// A vertex, numbered over all inputs, and its supports, each with the directions that it holds. The vertex
/// moves in the remaining directions.
struct HeldVertex {
    Index vertex = 0;
    std::vector<Hold> by;
};

struct SimulationOptions {
    /// Loads, winds and mirrors refer to the triangles of all sheets, numbered in the order of the inputs. A
    /// step that cannot be solved is halved. The stepper's tolerance is set from `tolerance`.
    StepperOptions stepper = {.contact = {.sheets = true}};
    std::vector<Edge> cracks;      ///< edges that have failed before the run, numbered over all inputs
    std::vector<HeldVertex> held;  ///< vertices with supports numbered below StepperOptions::supports
    std::vector<Gauge> gauges;
    FaceFieldChoice fields;   ///< fields of snapshots
    int max_iterations = 50;  ///< limit on those of the minimiser, except between two stages
    double tolerance = 1e-6;  ///< largest coordinate of the last correction, in mean edge lengths
    BreakingRule rule = BreakingRule::staged;
    int max_stages = 100;  ///< stages of staged breaking in one step
    /// Whether implicit and explicit steps alternate (StepPace), beginning with implicit ones. Explicit steps
    /// have the stepper's length, halved until it is at most explicit_step, s. If one fails (Stepper::solve()
    /// throws), it is made with implicit steps, as are some after it.
    bool alternates = false;
    double explicit_step = 2e-6;
    /// Whether the run ends with the first hinges that fail. The step is halved as often as possible to find
    /// their time; no new equilibrium is sought.
    bool until_crack = false;
};

/// Sheets that move, bend and break.
class Simulation {
  public:
    /// Takes the sheets as they start.
    Simulation(BreakableShell sheets, const SimulationOptions& options);
    /// Makes the sheets of at least one input.
    Simulation(const std::vector<SheetInput>& inputs, const SimulationOptions& options)
        : Simulation(BreakableShell(inputs), options) {}
    Simulation(const Simulation&) = delete;  // the stepper refers to the shell

    /// Advances by one time step: solves it, compares the hinges with their strengths, breaks the most
    /// overloaded ones and solves the same step again until no hinge is overloaded (or, by the paper's rule,
    /// breaks all overloaded hinges at the end). A step that cannot be solved is halved and tried again;
    /// hinges that broke in it stay broken, since they failed in a solution. Throws Error (run) when the
    /// smallest step cannot be solved.
    StepReport step();

    Snapshot snapshot() const { return snapshot(options.fields); }
    Snapshot snapshot(const FaceFieldChoice& fields) const;

    // Interventions between two steps. visit_state() does not store prescribed motions.

    /// Makes these forces, [3, V] N, act on the vertices from the next step on, until others are given: see
    /// GivenForces. Throws Error without ShellEnergyOptions::given_forces, and if there are not V.
    void give_forces(const Positions& forces);
    /// Moves vertices that pins hold in all directions, straight and at constant speed, to `positions` [3, n]
    /// m, where they arrive at `then` (s) and stay. Throws Error if a vertex is not held so, or if `then` is
    /// not later than now.
    void prescribe(std::span<const Index> vertices, const Positions& positions, double then);
    /// Makes the hinges of edges fail, whatever their strength, and opens the mesh. Events have the number of
    /// the last step. Throws Error if an edge has no hinge or is given twice, and like CrackMesh::fail().
    void break_by_hand(std::span<const Edge> edges);

    const BreakableShell& shell() const { return breakable; }
    const std::vector<Obstacle>& obstacles() const { return options.stepper.contact.obstacles; }
    const std::vector<RigidBody>& bodies() const { return stepper->bodies(); }
    const std::vector<Gauge>& gauges() const { return options.gauges; }
    const HingePeaks& peaks() const { return hinge_peaks; }
    /// Number of edges that ArtDirection::smallest has kept from failing.
    Index forbidden_failures() const { return forbidden; }
    /// Number of edges that have failed by toughness, nucleation included.
    Index grown_edges() const { return grown; }
    /// [O] and [B]: whether anything was in contact with the obstacle, or the body, at the end of a step so
    /// far.
    const std::vector<char>& touched_obstacles() const { return obstacles_touched; }
    const std::vector<char>& touched_bodies() const { return bodies_touched; }
    /// Returns the crack events since the last call.
    CrackEvents take_events();
    double time() const { return step_size.time(); }  ///< s; see StepperOptions::scheme
    /// Whether the run has ended: SimulationOptions::until_crack, Stepper::arrived().
    bool arrived() const { return ends_at_crack || stepper->arrived(); }
    /// The wall time of all steps by task.
    const TimeSpent& time_spent() const { return stepper->time_spent(); }
    /// Visits all that a simulation of the same input needs to continue from here bit for bit.
    void visit_state(StateVisitor& visit);

  private:
    /// Strains and measures of hinges at the stepper's position.
    struct Measured {
        FaceStrains strains;
        HingeMeasures hinges;
    };
    [[noreturn]] void give_up(const StepReport& report) const;
    /// Solves a step from its beginning, failures included. Returns whether it succeeded; otherwise `urgency`
    /// is the reason.
    bool attempt(StepReport& report);
    /// First solution of a step. Where schemes alternate, the error of explicit steps is stored in
    /// `overwhelmed`.
    MinimiserResult first_solution(StepReport& report);
    /// Prepares another attempt: another scheme, or half the step. Returns false if nothing is left to try.
    bool try_otherwise(StepReport& report);
    /// Decides whether an implicit step that has been solved must be replaced by explicit ones.
    Urgency judged(const StepReport& report, const Measured& measured);
    void go_explicit(StepReport& report);
    void change_scheme(Scheme scheme);
    /// Breaks and solves again until nothing is overloaded. Returns the result of the last solution.
    MinimiserResult break_in_stages(StepReport& report, MinimiserResult newton, Measured measured);
    Measured measured() const;
    /// Next edges of cracks by toughness. waited: see Judged.
    std::vector<CrackStep> next_crack_steps(const Measured& measured, double waited);
    /// Whether any edge fails, by strength or by toughness.
    bool fails(const Measured& measured);
    MinimiserResult solve_stage(StepReport& report, int max_iterations);
    void break_edges(std::span<const Edge> edges, const HingeMeasures& measures, Index stage,
                     const std::optional<Opening>& opening = {});
    /// Breaks the edge of a crack that propagates by toughness, and releases residual stress.
    void break_by_toughness(Edge edge, Index stage);
    /// Returns the edges that may fail in a stage: see ArtDirection::smallest.
    std::vector<Edge> allowed(std::vector<Edge> edges);
    /// Propagates cracks, one edge after the other. Returns whether the shell has changed.
    bool grow(std::span<const CrackStep> crack_steps, Index stage);
    /// Inserts an edge along the ray of a step, and keeps the edges of the steps `made_before`.
    std::optional<BreakableShell::Advanced> make_edge(const CrackStep& crack_step,
                                                      std::span<const CrackStep> made_before);
    /// Opening of the edge of a crack that propagates by toughness; none if `has`, the energy released
    /// already, J, suffices.
    std::optional<Opening> opening_of(Edge edge, double has) const;
    /// Sets the prescribed motion of a vertex alone.
    void set_motion(Index vertex, const Motion& motion);
    /// Updates all that refers to the shell after a change of it.
    void follow_change(const BreakableShell::Change& change);
    void record_failures(std::span<const Edge> edges, const HingeMeasures& measures, Index stage);
    void record_change(const CrackMesh::Change& change);
    /// Prepares the sheets: locks the geometry of loads, opens the cracks of the start and records them as
    /// events, and re-enables contact between surfaces that are apart.
    BreakableShell at_start(BreakableShell sheets);
    void open_cracks(BreakableShell& sheets);
    void update_fragments();
    /// Re-enables contact between crack faces, and between what overlapped at the start, that are apart where
    /// everything is at `time` (s). Returns whether any are.
    bool release_apart(BreakableShell& sheets, const std::vector<RigidBody>& bodies, double time) const;
    void report_peaks(StepReport& report, const Measured& measured) const;
    void finish(StepReport& report);
    void pace_on(const StepReport& report);
    void add_touch(StepReport& report);
    void read_gauges(StepReport& report) const;

    SimulationOptions options;
    std::int64_t steps = 0;
    CrackEvents events;
    double residual = 0, residual_at_start = 0;  ///< J, of residual stress
    BreakableShell breakable;
    std::unique_ptr<Stepper> stepper;
    CrackGrowth growth;
    Fragments fragments;
    HingePeaks hinge_peaks;
    std::vector<char> obstacles_touched, bodies_touched;
    StepSize step_size;
    StepPace pace;
    Urgency urgency = Urgency::none;  ///< reason for which the last attempt failed
    std::string overwhelmed;          ///< error of the last explicit step that failed
    /// Whether steps are explicit because implicit ones have failed, too: overlaps may then exceed those that
    /// barriers permit.
    bool is_last_resort = false;
    bool is_resort_tried = false;  ///< whether this has been tried in the open step
    bool ends_at_crack = false;
    Index forbidden = 0, grown = 0;
    std::size_t scripts = 0;  ///< number of prescribed motions at the start
};

}  // namespace sherd
