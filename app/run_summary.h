// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <string>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// What a run adds up over its steps.
struct RunTotals {
    std::size_t cracks = 0, capped = 0;
    std::int64_t newton_iterations = 0, halvings = 0;
    double smallest_step = std::numeric_limits<double>::infinity();  ///< s
    StepReport peaks;
    StepReport last;

    void add(const StepReport& report, const CrackEvents& events);
};

/// How a run ended.
struct RunEnd {
    std::string how;  ///< "complete" or "interrupted"
    std::filesystem::path recording;
    double wall_seconds = 0;
};

/// The table that a run ends with, for people. When nothing broke it has the peaks of the hinges, and where
/// nothing touched an obstacle its name.
std::string run_summary(const RunTotals& totals, const RunEnd& end, const Scene& scene,
                        const Simulation& simulation);

}  // namespace sherd
