// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "app/run/checkpoint.h"
#include "app/run/run_recorder.h"
#include "app/run/run_totals.h"
#include "app/run/runner.h"

namespace sherd {

/// Parts of a run whose state a checkpoint stores.
struct RunParts {
    Runner& runner;
    RunTotals& totals;
    RunRecorder& recorder;
    bool at_start = true;  ///< see Checkpoint::at_start

    void visit_state(StateVisitor& visit) {
        auto& [runner, totals, recorder, at_start] = *this;
        if (!at_start) visit(runner);
        visit(totals, recorder);
    }
};

/// Writes checkpoints of a run beside its recording: at its start, every Scene::checkpoint_interval (unless
/// this is 0), and at its end. A complete run keeps its last checkpoint, so that it can be made longer later.
/// If the only checkpoint of a complete run is the one at its start, the run keeps none: it was shorter than
/// the interval, and is repeated easily.
class CheckpointKeeper : public RunObserver {
  public:
    /// The objects to which `parts` refers must outlive this object. It must be the last observer of the
    /// runner, since it stores the state of the observers before it.
    CheckpointKeeper(const RunParts& parts, RunOrigin origin) : parts(parts), origin(std::move(origin)) {}

    /// Restores the state of a checkpoint; RunRecorder::resume() must be called afterwards. Throws Error
    /// (input), with the differences, if the origin or the frame interval of the run differs from that of the
    /// checkpoint, or if the run would end before the checkpoint.
    void restore(const Checkpoint& checkpoint);
    void paused(bool at_end) override;
    void ended(const RunEnd& how) override;

    double seconds() const { return spent; }  ///< s, wall time spent on checkpoints

  private:
    using Clock = std::chrono::steady_clock;

    void require_same_run(const Checkpoint& checkpoint) const;
    void write();

    RunParts parts;
    RunOrigin origin;
    std::int64_t number = 0;  ///< number of the last checkpoint; 0: none
    Clock::time_point last = {};
    double spent = 0;
};

}  // namespace sherd
