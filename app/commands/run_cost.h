// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/scene.h"
#include "fracture/step/step_report.h"

namespace sherd {

/// Measurement of the first steps of a scene.
struct TriedSteps {
    int count = 0;
    double first = 0, later = 0;  ///< s, wall time of the first step, and expected of each later step
    std::string failure;          ///< why a step failed; empty: none failed
    StepReport peaks;             ///< only the peaks of these steps are set: raise_peaks()
};

/// Estimated cost of a run.
struct RunCost {
    std::int64_t steps = 0, frames = 0;
    double recording = 0;       ///< bytes, size of the recording if nothing breaks
    double seconds = 0;         ///< s, wall time; 0 without trial steps
    double memory = 0;          ///< bytes, memory as estimated from the size of the mesh
    double peak_memory = 0;     ///< bytes, largest memory of this program so far; 0 without trial steps
    double machine_memory = 0;  ///< bytes, memory of the machine
};

/// Estimates the cost without trial steps.
RunCost run_cost(const Scene& scene, const BuiltScene& built);

/// Makes and measures up to three steps of the scene; begins no further step after some seconds.
TriedSteps try_steps(const Scene& scene, BuiltScene built);

/// Adds the time and the memory that trial steps have shown.
void add(RunCost& cost, const TriedSteps& tried);

/// The cost as text.
std::string cost_lines(const RunCost& cost);

/// Adds warnings if a run will take more than a day, or more memory than the machine has.
void warn_of_cost(const Scene& scene, const RunCost& cost, std::vector<std::string>& warnings);

}  // namespace sherd
