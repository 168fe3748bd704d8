// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/run/run_end.h"
#include "fracture/simulation.h"

namespace sherd {

/// Wants to know of a run while it goes on, as its progress, its recording and its interruption do. What an
/// observer throws ends the run.
class RunObserver {
  public:
    virtual ~RunObserver() = default;
    /// A step has been done, and this broke in it.
    virtual void stepped(const StepReport&, const CrackEvents&) {}
    /// A frame is due: where a run begins, where the scene wants one, and where a run is interrupted.
    virtual void frame_due(const Simulation&) {}
    /// The run stands between two steps, of which all observers know, and before the frame that may be due
    /// there. at_end: no step follows.
    virtual void paused(bool /*at_end*/) {}
    /// Says whether the run is to end after the step that has been done.
    virtual bool wants_end() const { return false; }
    /// The run has ended; no other call follows.
    virtual void ended(const RunEnd&) {}
};

}  // namespace sherd
