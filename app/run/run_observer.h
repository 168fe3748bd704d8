// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "fracture/step/simulation.h"

namespace sherd {

/// How a run ended.
struct RunEnd {
    std::string how;          ///< "complete", "interrupted" or "failed: ..."
    double wall_seconds = 0;  ///< s, wall time of Runner::run(), with the runs that it resumed

    bool is_complete() const { return how == "complete"; }
    bool has_failed() const { return how.starts_with("failed"); }
};

/// Observer of a run, such as its progress display, its recorder, or the object that ends it on Ctrl-C. An
/// exception of an observer ends the run.
class RunObserver {
  public:
    virtual ~RunObserver() = default;
    /// Called after a step, with its report and its crack events.
    virtual void stepped(const StepReport&, const CrackEvents&) {}
    /// Called when a frame is due: at the start of a run, at the intervals that the scene asks for, and at
    /// the end of a run, even if that is early.
    virtual void frame_due(const Simulation&) {}
    /// Called before the first step, and whenever a multiple of the scene's step or the end of the run is
    /// reached: after all observers' stepped(), and before the frame that may be due then. at_end: whether no
    /// step follows.
    virtual void paused(bool /*at_end*/) {}
    /// Returns whether the run must end now, before another step.
    virtual bool should_end() const { return false; }
    /// Called when the run has ended; no other call follows.
    virtual void ended(const RunEnd&) {}
};

}  // namespace sherd
