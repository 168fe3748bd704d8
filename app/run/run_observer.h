// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "fracture/step/simulation.h"

namespace sherd {

/// How a run ended.
struct RunEnd {
    std::string how;          ///< "complete", "interrupted" or "failed: ..."
    double wall_seconds = 0;  ///< s, from its first step on

    bool is_complete() const { return how == "complete"; }
    bool has_failed() const { return how.starts_with("failed"); }
};

/// Observer of a run, such as its progress, its recorder and its interruption. An exception of an observer
/// ends the run.
class RunObserver {
  public:
    virtual ~RunObserver() = default;
    /// Called after a step, with the cracks in it.
    virtual void stepped(const StepReport&, const CrackEvents&) {}
    /// Called when a frame is due: at the start of a run, when the scene asks for one, and when a run ends
    /// early.
    virtual void frame_due(const Simulation&) {}
    /// Called between two steps, after all observers' stepped(), and before the frame that may be due then.
    /// at_end: no step follows.
    virtual void paused(bool /*at_end*/) {}
    /// Whether the run is to end after the last step.
    virtual bool should_end() const { return false; }
    /// Called when the run has ended; no other call follows.
    virtual void ended(const RunEnd&) {}
};

}  // namespace sherd
