// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
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

    const Scene& scene() const { return definition; }
    const Simulation& simulation() const { return stepped; }

  private:
    void step_to_the_end();
    bool is_over() const;
    void record();
    void end(const RunEnd& how);

    Scene definition;
    Simulation stepped;
    std::vector<std::reference_wrapper<RunObserver>> observers;
};

}  // namespace sherd
