// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/build/built_scene.h"
#include "app/scene/scene.h"
#include "fracture/step_report.h"

namespace sherd {

/// The first steps of a scene, done to see what one takes.
struct TriedSteps {
    int count = 0;
    double first = 0, later = 0;  ///< s of wall time, of the first step and of one of those that follow
    std::string failure;          ///< why a step could not be done; empty: all could
    StepReport peaks;             ///< of these steps: raise_peaks()
};

/// What a run will take.
struct RunCost {
    std::int64_t steps = 0, frames = 0;
    double recording = 0;       ///< bytes, of the unbroken mesh
    double seconds = 0;         ///< of wall time; 0 when nothing was tried
    double memory = 0;          ///< bytes, guessed from the size of the mesh
    double peak_memory = 0;     ///< bytes, of this program so far; 0 when nothing was tried
    double machine_memory = 0;  ///< bytes
};

/// What can be said without a step.
RunCost run_cost(const Scene& scene, const BuiltScene& built);

/// Does up to three steps, and begins none after some seconds.
TriedSteps try_steps(const Scene& scene, BuiltScene built);

/// Adds what was seen in trying.
void add(RunCost& cost, const TriedSteps& tried);

/// For people.
std::string cost_lines(const RunCost& cost);

/// Warns of more than a day, and of more memory than the machine has.
void warn_of_cost(const Scene& scene, const RunCost& cost, std::vector<std::string>& warnings);

}  // namespace sherd
