// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "app/run/checkpoint.h"
#include "app/run/run_recorder.h"
#include "app/run/run_totals.h"
#include "app/run/runner.h"

namespace sherd {

/// All of a run that goes on where it was.
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

/// Keeps checkpoints of a run beside its recording: at its begin, every Scene::checkpoint_interval, and at
/// its end. A complete run keeps the last, so that it can be made longer, or none if it was complete before
/// the first after its begin: to repeat such a run takes less than the interval.
class CheckpointKeeper : public RunObserver {
  public:
    /// The parts must outlive this object. It must be the last observer, since it needs to know what the
    /// others do.
    CheckpointKeeper(const RunParts& parts, RunOrigin origin) : parts(parts), origin(std::move(origin)) {}

    /// Puts the state of a checkpoint back; RunRecorder::go_on() is left to do. Throws Error (input), with
    /// all that has changed, unless the run is of the same origin, and of no shorter duration.
    void put_back(const Checkpoint& checkpoint);
    void paused(bool at_end) override;
    void ended(const RunEnd& how) override;

    double seconds() const { return spent; }  ///< s, of wall time, on checkpoints

  private:
    using Clock = std::chrono::steady_clock;

    void require_same_run(const Checkpoint& checkpoint) const;
    void write();

    RunParts parts;
    RunOrigin origin;
    std::int64_t number = 0;  ///< of the last one
    Clock::time_point last = {};
    double spent = 0;
};

}  // namespace sherd
