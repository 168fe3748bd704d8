// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/recording/recording.h"
#include "app/run/obstacle_track.h"
#include "app/run/run_observer.h"
#include "app/scene/scene.h"

namespace sherd {

/// Writes a run into a recording.
class RunRecorder : public RunObserver {
  public:
    /// Creates the recording of a scene's run. The simulation must be that of the scene, before its first
    /// step. With `resumes`, opens the existing recording instead, whose state must be restored afterwards
    /// (see RecordingWriter). Throws Error (input) if the recording cannot be created.
    RunRecorder(RecordingOutput output, const Scene& scene, const Simulation& simulation,
                bool resumes = false);

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void frame_due(const Simulation& simulation) override;
    void ended(const RunEnd& end) override;

    double seconds() const { return spent; }  ///< s, wall time spent on frames

    void visit_state(StateVisitor& visit) {
        auto& [obstacles, writer, unrecorded, unrecorded_events, spent] = *this;
        visit(writer, unrecorded, unrecorded_events);
    }
    void resume(const Scene& scene) { writer.resume(scene.text); }
    const OutputLock& lock() const { return writer.lock(); }

  private:
    ObstacleTrack obstacles;
    RecordingWriter writer;
    std::vector<StepReport> unrecorded;
    CrackEvents unrecorded_events;
    double spent = 0;
};

}  // namespace sherd
