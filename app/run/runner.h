// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/run_observer.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/scene.h"

namespace sherd {

/// Runs a scene, and notifies observers.
class Runner {
  public:
    /// built: sheets and options built from the scene.
    Runner(Scene scene, BuiltScene built);

    /// Adds an observer, which must outlive this object. Observers are notified in the order in which they
    /// were added.
    void add(RunObserver& observer) { observers.push_back(observer); }

    /// Steps from the simulation's time to the end of the scene's duration, or until an observer asks for the
    /// end. Rethrows exceptions of a step or an observer, after notifying the observers that the run has
    /// failed.
    RunEnd run();

    /// Makes a single step, and notifies the observers. The step is shorter than the scene's if it had to be
    /// halved. Throws Error (run) if it cannot be solved.
    StepReport step();
    /// Makes a single step as part of run(), with the frame that may be due at its end.
    StepReport advance();

    /// Whether no step follows: the scene's end has been reached, or an observer asks for the end.
    bool has_ended() const;
    /// Whether the scene's end has been reached.
    bool is_complete() const;
    /// End of the scene's last step, in its unit of time: later than its duration if that is not a number of
    /// steps, or by rounding.
    double end_time() const;
    double wall_seconds() const;  ///< s, of run(), including the runs that this one resumes

    const Scene& scene() const { return definition; }
    const Simulation& simulation() const { return stepped; }
    Simulation& simulation() { return stepped; }  ///< may be changed between two steps

    /// Visits the simulation and the wall time. When they have been restored, run() resumes from there.
    void visit_state(StateVisitor& visit);

  private:
    using Clock = std::chrono::steady_clock;

    void step_to_the_end();
    bool is_over() const;
    std::int64_t done() const;  ///< number of the scene's steps that have been made
    /// Whether a frame is due at the simulation's time.
    bool has_frame_now() const;
    void pause();
    void record();
    void end(const RunEnd& how);

    Scene definition;
    Simulation stepped;
    std::vector<std::reference_wrapper<RunObserver>> observers;
    bool resumed = false;
    double seconds_before = 0;                      ///< s, wall time of the runs before
    std::optional<Clock::time_point> started = {};  ///< none: before run()
};

}  // namespace sherd
