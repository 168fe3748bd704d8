// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/progress/progress_meter.h"

namespace sherd {

/// How far a run is.
struct RunProgress {
    std::int64_t step = 0;
    double time = 0, duration = 0;  ///< simulated
    double step_size = 0;           ///< now
    std::int64_t cracks = 0, fragments = 0, halvings = 0;
    std::string unit = "s";  ///< of its times: Scene::time_unit()
};

/// What is said of it; the halvings of steps when there have been any.
ProgressText progress_text(const RunProgress& progress);

/// One line of numbers, for another process of this program.
std::string to_line(const RunProgress& progress);
/// None when the line is not one of to_line().
std::optional<RunProgress> run_progress(const std::string& line);

}  // namespace sherd
