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

/// A vertex, numbered over all inputs, and what holds it, each in its own directions. It moves in those that
/// are left.
struct HeldVertex {
    Index vertex = 0;
    std::vector<Hold> by;
};

struct SimulationOptions {
    /// Loads, winds and mirrors refer to the triangles of all sheets, numbered in the order of the inputs. A
    /// step that cannot be solved is halved. The stepper's tolerance is set from `tolerance`.
    StepperOptions stepper = {.contact = {.sheets = true}};
    std::vector<Edge> cracks;      ///< edges that have failed before the run, numbered over all inputs
    std::vector<HeldVertex> held;  ///< by the first StepperOptions::supports numbers
    std::vector<Gauge> gauges;
    FaceFieldChoice fields;   ///< that snapshots have
    int max_iterations = 50;  ///< of the minimiser, except between two stages of breaking
    double tolerance = 1e-6;  ///< largest coordinate of the last correction, in mean edge lengths
    BreakingRule rule = BreakingRule::staged;
    int max_stages = 100;  ///< stages of staged breaking in one step
    /// Implicit and explicit steps alternate (StepPace), beginning with implicit ones. Explicit steps are
    /// parts, halved as often as need be, of the stepper's, so that they are not longer than explicit_step,
    /// s. One that cannot go on (Stepper::solve throws) is made by implicit ones, as some after it are.
    bool alternates = false;
    double explicit_step = 2e-6;
    /// End with the first hinges that fail. The step is halved as far as it can be to find their moment; no
    /// new equilibrium is sought.
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

    // Between two steps, from outside. A state that is put back by visit_state() knows nothing of motions.

    /// From the next step on these forces, [3, V] N, act on the vertices until others are given: see
    /// GivenForces. Throws Error without ShellEnergyOptions::given_forces, and when there are not V.
    void give_forces(const Positions& forces);
    /// Vertices that pins hold in all directions go, straight and at constant speed, to `positions` [3, n] m,
    /// where they are at `then` (s) and stay. Throws Error when one is not held so, or when that is not
    /// later.
    void prescribe(std::span<const Index> vertices, const Positions& positions, double then);
    /// Makes the hinges of edges fail, whatever their strength, and opens the mesh. What events there are
    /// have the number of the last step. Throws Error as CrackMesh::fail() does, and on a hinge that is none.
    void break_by_hand(std::span<const Edge> edges);

    const BreakableShell& shell() const { return breakable; }
    const std::vector<Obstacle>& obstacles() const { return options.stepper.contact.obstacles; }
    const std::vector<RigidBody>& bodies() const { return stepper->bodies(); }
    const std::vector<Gauge>& gauges() const { return options.gauges; }
    const HingePeaks& peaks() const { return hinge_peaks; }
    /// How many edges have been kept from failing by ArtDirection::smallest.
    Index forbidden_failures() const { return forbidden; }
    /// How many edges have failed by toughness, births among them.
    Index grown_edges() const { return grown; }
    /// [O] and [B]: whether anything was in contact with the obstacle, or the body, at the end of a step so
    /// far.
    const std::vector<char>& touched_obstacles() const { return obstacles_touched; }
    const std::vector<char>& touched_bodies() const { return bodies_touched; }
    /// Returns the crack events since the last call.
    CrackEvents take_events();
    double time() const { return step_size.time(); }  ///< s; see StepperOptions::scheme
    /// Whether there is no step to do any more: SimulationOptions::until_crack, Stepper::arrived().
    bool arrived() const { return ends_at_crack || stepper->arrived(); }
    /// The wall time of all steps by task.
    const TimeSpent& time_spent() const { return stepper->time_spent(); }
    /// All that a simulation of the same input needs to go on from here as this one does, bit for bit.
    void visit_state(StateVisitor& visit);

  private:
    /// What is judged, at the stepper's position.
    struct Measured {
        FaceStrains strains;
        HingeMeasures hinges;
    };
    [[noreturn]] void give_up(const StepReport& report) const;
    /// Solves a step from its beginning, including its breaking. Returns whether it is made; else urgency
    /// says why not.
    bool attempt(StepReport& report);
    /// Before anything is judged. Where schemes alternate, what ends explicit steps is kept in `overwhelmed`.
    MinimiserResult first_solution(StepReport& report);
    /// Makes what follows an attempt in vain another one. Returns false when nothing is left to try.
    bool try_otherwise(StepReport& report);
    /// Judges an implicit step that has been solved.
    Urgency judged(const StepReport& report, const Measured& measured);
    void go_explicit(StepReport& report);
    void change_scheme(Scheme scheme);
    /// Breaks and solves again until nothing is overloaded. Returns the result of the last solution.
    MinimiserResult break_in_stages(StepReport& report, MinimiserResult newton, Measured measured);
    Measured measured() const;
    /// What cracks by toughness do next. waited: see Judged.
    std::vector<CrackStep> next_crack_steps(const Measured& measured, double waited);
    /// Whether anything fails at all.
    bool fails(const Measured& measured);
    MinimiserResult solve_stage(StepReport& report, int max_iterations);
    void break_edges(std::span<const Edge> edges, const HingeMeasures& measures, Index stage,
                     const std::optional<Opening>& opening = {});
    /// Breaks the edge of a crack that goes by toughness, which takes residual stress with it.
    void break_by_toughness(Edge edge, Index stage);
    /// Those of the edges that fail in a stage that may: see ArtDirection::smallest.
    std::vector<Edge> allowed(std::vector<Edge> edges);
    /// Lets cracks go on, one edge after the other. Returns whether the shell has changed.
    bool grow(std::span<const CrackStep> crack_steps, Index stage);
    /// Makes an edge along the ray of a step, beside those made before, which stay.
    std::optional<BreakableShell::Advanced> make_edge(const CrackStep& crack_step,
                                                      std::span<const CrackStep> made_before);
    /// How the edge of a crack that goes by toughness opens; has: J, that it need not take from what carries.
    std::optional<Opening> opening_of(Edge edge, double has) const;
    /// Gives a vertex a motion of its own.
    void set_motion(Index vertex, const Motion& motion);
    /// Lets all that refers to the shell follow a change of it.
    void follow_change(const BreakableShell::Change& change);
    void record_failures(std::span<const Edge> edges, const HingeMeasures& measures, Index stage);
    void record_change(const CrackMesh::Change& change);
    /// Keeps what loads refer to, opens what has failed before the run, begins the list of events with it,
    /// and lets what is apart at the start meet.
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
    Urgency urgency = Urgency::none;  ///< of the last attempt
    std::string overwhelmed;          ///< what ended the last explicit step that could not go on
    /// Whether steps are explicit because implicit ones cannot go on, either: they may then press sheets
    /// deeper than barriers bear.
    bool is_last_resort = false;
    bool is_resort_tried = false;  ///< in the open step
    bool ends_at_crack = false;
    Index forbidden = 0, grown = 0;
    std::size_t scripts = 0;  ///< motions of the start
};

}  // namespace sherd
