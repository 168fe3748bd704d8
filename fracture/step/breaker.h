// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/state_visitor.h"
#include "core/time/stepper.h"
#include "fracture/cracks/crack_growth.h"
#include "fracture/record/events.h"
#include "fracture/record/fragments.h"
#include "fracture/record/hinge_peaks.h"
#include "fracture/step/simulation_options.h"

namespace sherd {

/// Strains of faces and measures of hinges in a solution.
struct Measured {
    FaceStrains strains;
    HingeMeasures hinges;
};

/// A stage of breaking in the open step.
struct BreakingStage {
    std::int64_t step = 0;      ///< number of the step
    double begin = 0, end = 0;  ///< s, beginning and end of the step
    Index number = 0;
    double waited = 0;  ///< s: see CrackEvaluation
};

/// Outcome of a stage: whether the sheets have changed; `capped`: edges were about to fail, but the limit on
/// stages prevented it.
enum class StageOutcome { unchanged, capped, broken };

/// Breaks the sheets of a simulation: finds the edges that fail, opens the mesh there, passes the change on
/// to all objects that refer to the mesh, and records it. A stepper given to its functions must be the
/// stepper of the sheets; for functions that change the sheets, a step must be open.
class Breaker {
  public:
    /// Opens options.cracks, which exist from the start. The sheets must outlive this object.
    Breaker(BreakableShell& sheets, const SimulationOptions& options);
    Breaker(const Breaker&) = delete;  // members refer to the sheets

    /// Strains and measures at the stepper's position.
    Measured measured(const Stepper& stepper) const;
    /// Measures of the hinges of some edges alone, with the same bits.
    std::vector<HingeMeasure> measured(std::span<const Edge> edges, const Stepper& stepper) const;
    /// Whether any edge fails, by strength or by toughness.
    bool fails(const Measured& now, const BreakingStage& stage, Stepper& stepper);
    /// Makes the most overloaded edges fail, propagates cracks by toughness, and opens the mesh; if
    /// `may_break` is false, changes nothing.
    StageOutcome break_stage(const Measured& now, const BreakingStage& stage, bool may_break,
                             Stepper& stepper);
    /// Makes all overloaded edges fail, by the paper's rule, and propagates cracks by toughness. Returns the
    /// number of stages, 0 to 2.
    Index break_at_once(const Measured& now, BreakingStage stage, Stepper& stepper);
    /// Makes the hinges of edges fail, whatever their strength. measures: measures of these hinges, for the
    /// record.
    void break_given(std::span<const Edge> edges, std::span<const HingeMeasure> measures,
                     const BreakingStage& stage, Stepper& stepper);

    /// Estimate of the time, s, that is left until an edge fails, after a step that ended at `time` (s) with
    /// these measures before anything failed: see CrackGrowth::time_left(). Of sheets without toughness, 0 if
    /// bears_half(), else infinite.
    double time_left(const HingeMeasures& measures, double time) const;
    /// Records the measures of a solution. They replace the measures of an earlier attempt at the step.
    void record_measures(const HingeMeasures& measures) { hinge_peaks.record(shell, measures); }
    /// Must be called when a step ends, at `time` (s): completes its events. broken: whether anything failed.
    void finish_step(std::int64_t step, double time, bool broken);
    /// Must be called after break_given(): completes its events. time: s.
    void finish_given(std::int64_t step, double time);

    /// Returns the crack events since the last call.
    CrackEvents take_events() { return std::exchange(events, {}); }
    const std::vector<Gauge>& gauges() const { return all_gauges; }
    const Fragments& fragments() const { return pieces; }
    const HingePeaks& peaks() const { return hinge_peaks; }
    double residual() const { return residual_now; }  ///< J, stored by residual stress
    /// Energy of residual stress that cracks have released so far, J.
    double residual_taken() const { return residual_at_start - residual_now; }
    /// Number of edges that ArtDirection::smallest has kept from failing.
    Index prevented_failures() const { return prevented; }
    /// Number of edges that have failed by toughness, nucleation included.
    Index grown_edges() const { return grown; }
    void visit_state(StateVisitor& visit) {
        auto& [staged, all_gauges, events, residual_at_start, residual_now, shell, growth, pieces,
               hinge_peaks, prevented, grown] = *this;
        visit(all_gauges, events, residual_now, growth, pieces, hinge_peaks, prevented, grown);
    }

  private:
    void record_fragments(std::int64_t step);
    /// Opens the cracks that exist from the start, and records them as events. Returns the sheets.
    BreakableShell& with_cracks(BreakableShell& sheets, std::span<const Edge> cracks);
    /// The next edges of cracks in sheets that have a toughness.
    std::vector<CrackStep> next_crack_steps(const Measured& now, const BreakingStage& stage,
                                            Stepper& stepper);
    /// Returns `edges` without those that must not fail: see ArtDirection::smallest.
    std::vector<Edge> allowed(std::vector<Edge> edges);
    void fail(std::span<const Edge> edges, std::span<const HingeMeasure> measures, const BreakingStage& stage,
              Stepper& stepper, const std::optional<Opening>& opening = {});
    /// Propagates cracks, one edge after the other. Returns whether the shell has changed.
    bool grow(std::span<const CrackStep> crack_steps, const BreakingStage& stage, Stepper& stepper);
    /// Makes an edge along the ray of `crack_step`, and keeps the edges of the steps `made_before` as they
    /// are. Returns nothing if there is no such edge.
    std::optional<BreakableShell::Advanced> make_edge(const CrackStep& crack_step,
                                                      std::span<const CrackStep> made_before,
                                                      const BreakingStage& stage, Stepper& stepper);
    /// Breaks the edge of a crack that propagates by toughness, and releases residual stress.
    void fail_by_toughness(Edge edge, const BreakingStage& stage, Stepper& stepper);
    /// Gradual opening of the edge of a crack that propagates by toughness; nothing if `available`, J, the
    /// energy released already, is as large as the fracture energy of the edge.
    std::optional<Opening> opening_of(Edge edge, double available) const;
    /// Updates all objects that refer to the sheets after a change of the sheets.
    void follow_change(const BreakableShell::Change& change, const BreakingStage& stage, Stepper& stepper);
    void record_failures(std::span<const Edge> edges, std::span<const HingeMeasure> measures,
                         const BreakingStage& stage);
    void record_change(const CrackMesh::Change& change, std::int64_t step);

    bool staged;  ///< BreakingRule::staged
    std::vector<Gauge> all_gauges;
    CrackEvents events;
    double residual_at_start = 0, residual_now = 0;  ///< J, stored by residual stress
    BreakableShell& shell;
    CrackGrowth growth;
    Fragments pieces;
    HingePeaks hinge_peaks;
    Index prevented = 0, grown = 0;
};

}  // namespace sherd
