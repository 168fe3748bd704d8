// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/run_observer.h"
#include "app/scene/build/built_scene.h"
#include "app/scene/scene.h"

namespace sherd {

/// Runs a scene: steps it and tells observers of it.
class Runner {
  public:
    /// Takes a scene and what was built of it.
    Runner(Scene scene, BuiltScene built);

    /// Observers are told one after the other, in the order in which they are added, and must outlive this.
    void add(RunObserver& observer) { observers.push_back(observer); }

    /// Steps on from where the simulation stands to the end of the scene's duration, or until an observer
    /// wants an end. Throws what a step or an observer throws, when the observers know that the run has
    /// failed.
    RunEnd run();

    /// Makes a single step, of which the observers are told, too. It is shorter than the scene's when it had
    /// to be halved. Throws Error (run) when it cannot be solved.
    StepReport step();
    /// The same as a part of run(): observers are told, too, of the frame that may be due at its end.
    StepReport advance();

    /// Says whether no step follows: the scene's end has been reached, or an observer wants an end.
    bool has_ended() const;
    /// Says whether the scene's end has been reached.
    bool is_complete() const;
    /// Where the last of the scene's steps ends, in its unit of time: past its duration if that is not a
    /// number of steps, or by rounding.
    double end_time() const;
    double wall_seconds() const;  ///< s, of run(), in the runs that this one goes on from, too

    const Scene& scene() const { return definition; }
    const Simulation& simulation() const { return stepped; }
    Simulation& simulation() { return stepped; }  ///< to be changed between two steps

    /// Where the simulation stands. When it has been put back, run() goes on from there.
    void visit_state(StateVisitor& visit);

  private:
    using Clock = std::chrono::steady_clock;

    void step_to_the_end();
    bool is_over() const;
    std::int64_t done() const;  ///< how many of the scene's steps have been made
    /// Whether a frame is due where the simulation stands, at the end of a step of the scene or after it.
    bool has_frame_now() const;
    void pause();
    void record();
    void end(const RunEnd& how);

    Scene definition;
    Simulation stepped;
    std::vector<std::reference_wrapper<RunObserver>> observers;
    bool resumed = false;
    double seconds_before = 0;                      ///< s, of wall time, in the runs before
    std::optional<Clock::time_point> started = {};  ///< none: run() has not begun
};

}  // namespace sherd
