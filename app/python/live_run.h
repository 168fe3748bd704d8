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

/// The right to use a run, which one thread has at a time: others must not look at it while it steps.
class Turn {
  public:
    /// Throws Error when another thread has it.
    explicit Turn(std::atomic<bool>& taken);
    ~Turn() { taken = false; }
    Turn(const Turn&) = delete;

  private:
    std::atomic<bool>& taken;
};

/// A run that Python steps, and that may be recorded. Each member throws Error while another thread is in
/// step().
class LiveRun : RunObserver {
  public:
    /// threads: at most; results do not depend on them.
    LiveRun(const Scene& scene, int threads);

    /// Leaves Python's lock to others meanwhile. Frames of a recording are written with it, since HDF5 is for
    /// one thread at a time.
    void step();
    bool has_ended();
    const Simulation& simulation();
    /// To be changed between two steps.
    Simulation& changed();

    /// Begins to record. Throws Error (input) after the first step, when the run is being recorded, or when
    /// the recording cannot be created.
    void record(const std::filesystem::path& file, bool force);
    /// Ends the recording; failure: why the run failed, empty: it did not.
    void end_recording(const std::string& failure);

    const Scene& scene() const { return runner.scene(); }
    const std::vector<std::string>& warnings() const { return told; }
    const std::optional<StepReport>& report();  ///< of the last step
    const CrackEvents& events();                ///< since the start

  private:
    using Clock = std::chrono::steady_clock;
    struct LiveRecording {
        RunRecorder recorder;
        Clock::time_point begin = Clock::now();
        double last_frame = 0;  ///< s
    };

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void frame_due(const Simulation& simulation) override;

    std::vector<std::string> told;
    Runner runner;
    std::atomic<bool> taken = false;
    std::optional<StepReport> last;
    CrackEvents all_events;
    std::unique_ptr<LiveRecording> recording;
};

}  // namespace sherd::python
