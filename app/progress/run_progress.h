// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/progress/progress_meter.h"

namespace sherd {

/// Progress of a run.
struct RunProgress {
    std::int64_t step = 0;
    double time = 0, duration = 0;  ///< simulated time so far, and at the end, in `unit`
    double step_size = 0;           ///< size of the last step, in `unit`
    std::int64_t cracks = 0, fragments = 0, halvings = 0;  ///< numbers so far
    std::string unit = "s";                                ///< unit of times: Scene::time_unit()
};

/// Returns the texts on a run's progress, with the halvings of steps if there were any.
ProgressText progress_text(const RunProgress& progress);

/// Returns a line of numbers, which run_progress() reads in another process of this program.
std::string to_line(const RunProgress& progress);
/// Reads a line of to_line(); returns none if the line has another form.
std::optional<RunProgress> run_progress(const std::string& line);

}  // namespace sherd
