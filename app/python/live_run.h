// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/run_recorder.h"
#include "app/run/runner.h"

namespace sherd::python {

/// Exclusive use of a run by a thread during the lifetime of this object: no other thread may read the run
/// during a step.
class ExclusiveUse {
  public:
    /// Sets `taken`. Throws Error if `taken` is set already, since another thread then uses the run.
    explicit ExclusiveUse(std::atomic<bool>& taken);
    ~ExclusiveUse() { taken = false; }
    ExclusiveUse(const ExclusiveUse&) = delete;

  private:
    std::atomic<bool>& taken;
};

/// A run that Python steps, and that may be recorded. Each member throws Error while another thread is in
/// step().
class LiveRun : RunObserver {
  public:
    /// threads: largest number of threads in a step; results do not depend on it.
    LiveRun(const Scene& scene, int threads);

    /// Makes a step, without Python's lock. Frames of a recording are written with the lock, since only one
    /// thread at a time may use HDF5.
    void step();
    bool has_ended();
    const Simulation& simulation();
    /// Returns the simulation, to be changed between two steps.
    Simulation& changed();

    /// Starts a recording. Throws Error (input) after the first step, if the run is being recorded already,
    /// or if the recording cannot be created.
    void record(const std::filesystem::path& file, bool force);
    /// Ends the recording. failure: why the run failed, or "" if it did not fail.
    void end_recording(const std::string& failure);

    const Scene& scene() const { return runner.scene(); }
    const std::vector<std::string>& warnings() const { return warning_list; }
    const std::optional<StepReport>& report();  ///< none before the first step
    const CrackEvents& events();                ///< events since the start

  private:
    using Clock = std::chrono::steady_clock;
    struct LiveRecording {
        RunRecorder recorder;
        Clock::time_point begin = Clock::now();
        double last_frame = 0;  ///< s, time of the last frame
    };

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void frame_due(const Simulation& simulation) override;

    std::vector<std::string> warning_list;
    Runner runner;
    std::atomic<bool> taken = false;
    std::optional<StepReport> last;
    CrackEvents all_events;
    std::unique_ptr<LiveRecording> recording;
};

}  // namespace sherd::python
