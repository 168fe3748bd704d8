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
    bool at_start = true;  ///< Checkpoint::at_start

    void visit_state(StateVisitor& visit) {
        auto& [runner, totals, recorder, at_start] = *this;
        if (!at_start) visit(runner);
        visit(totals, recorder);
    }
};

/// Writes checkpoints of a run beside its recording: at its start, every Scene::checkpoint_interval, and at
/// its end. A complete run keeps the last, so that it can be made longer. It keeps none if it was complete
/// before the second checkpoint, since repeating such a run takes less than the interval.
class CheckpointKeeper : public RunObserver {
  public:
    /// The parts must outlive this object, which must be the last observer: it stores the state of the
    /// others.
    CheckpointKeeper(const RunParts& parts, RunOrigin origin) : parts(parts), origin(std::move(origin)) {}

    /// Restores the state of a checkpoint; RunRecorder::resume() must follow. Throws Error (input), with the
    /// differences, if the origin or the frame interval of the run differs, or if the run would end before
    /// the checkpoint.
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
    std::int64_t number = 0;  ///< number of the last checkpoint
    Clock::time_point last = {};
    double spent = 0;
};

}  // namespace sherd
