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
    /// built: sheets and options that were built from the scene.
    Runner(Scene scene, BuiltScene built);

    /// Adds an observer, which must outlive this object. Observers are notified in the order in which they
    /// were added.
    void add(RunObserver& observer) { observers.push_back(observer); }

    /// Steps from the simulation's time to the end of the scene, or until an observer asks for the end.
    /// Returns how the run ended. Rethrows exceptions of a step or an observer, after notifying the observers
    /// that the run has failed.
    RunEnd run();

    /// Makes a single step, and notifies the observers by stepped(). The step is shorter than the scene's
    /// step if it had to be halved. Returns its report. Throws Error (run) if it cannot be solved.
    StepReport step();
    /// Makes a single step as part of run(), and notifies the observers also by paused() and frame_due() if
    /// these are due at its end.
    StepReport advance();

    /// Whether no step follows: the end of the scene has been reached, or an observer asks for the end.
    bool has_ended() const;
    /// Whether the end of the scene has been reached: its last step, or in statics Simulation::arrived().
    bool is_complete() const;
    /// End of the scene's last step, in Scene::time_unit(): later than the duration if the duration is not a
    /// whole number of steps. Round-off may make the two differ, too.
    double end_time() const;
    double wall_seconds() const;  ///< s, wall time of run(), and of the runs that it resumes

    const Scene& scene() const { return definition; }
    const Simulation& simulation() const { return stepped; }
    Simulation& simulation() { return stepped; }  ///< the simulation may be changed between two steps

    /// Visits the simulation and the wall time. After they have been restored, run() continues from the
    /// restored time.
    void visit_state(StateVisitor& visit);

  private:
    using Clock = std::chrono::steady_clock;

    void step_to_the_end();
    bool is_over() const;
    std::int64_t done() const;  ///< number of whole steps of the scene that have been made
    /// Whether a frame is due at the simulation's time.
    bool has_frame_now() const;
    void pause();
    void record();
    void end(const RunEnd& how);

    Scene definition;
    Simulation stepped;
    std::vector<std::reference_wrapper<RunObserver>> observers;
    bool resumed = false;
    double seconds_before = 0;                      ///< s, wall time of the runs that this one resumes
    std::optional<Clock::time_point> started = {};  ///< start of run(); none: run() has not been called
};

}  // namespace sherd
