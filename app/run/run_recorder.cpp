// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/run_recorder.h"

#include <chrono>
#include <utility>

#include "app/run/recording_header.h"
#include "meshops/error.h"

namespace sherd {

RunRecorder::RunRecorder(RecordingOutput output, const Scene& scene, const Simulation& simulation,
                         bool resumes)
    : obstacles(scene, simulation),
      writer(std::move(output), recording_header(scene, simulation), obstacles.obstacles(), resumes) {}

void RunRecorder::stepped(const StepReport& report, const CrackEvents& events) {
    unrecorded.push_back(report);
    append(unrecorded_events, events);
}

void RunRecorder::frame_due(const Simulation& simulation) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    writer.append(simulation.snapshot(), unrecorded, unrecorded_events, obstacles.poses(simulation),
                  obstacles.shapes(simulation));
    unrecorded.clear();
    unrecorded_events = {};
    spent += std::chrono::duration<double>(Clock::now() - start).count();
}

void RunRecorder::ended(const RunEnd& end) try {
    writer.finish(end.wall_seconds, end.how);
} catch (const Error&) {
    if (!end.has_failed()) throw;  // the cause of the run's failure matters more than this error
}

}  // namespace sherd
