// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/progress/idle_timer.h"
#include "app/progress/live_lines.h"
#include "app/progress/progress_meter.h"

namespace sherd {

/// Shows the progress of concurrent tasks on stderr. On a terminal each task has a line with a bar, which is
/// drawn again in the same place. Elsewhere, for example in a file, a new line is printed whenever another
/// tenth of a task is done, and the last line of each running task is repeated if nothing was printed for
/// `idle`.
class ProgressDisplay {
  public:
    /// name_columns: width of the column of task names, the length of the longest one.
    explicit ProgressDisplay(std::size_t name_columns = 0,
                             std::chrono::milliseconds idle = std::chrono::seconds(30))
        : name_columns(name_columns), idle(idle) {}

    /// Starts the display, so that something is printed even if the first show() is late.
    void begin();
    /// Shows all running tasks; on a terminal at most ten times a second, unless `at_once` is true.
    void show(std::span<ProgressMeter* const> running, bool at_once = false);
    /// Leaves a last line of a task that has ended, above the lines of running tasks. Only on a terminal;
    /// elsewhere the lines for tenths suffice.
    void leave(const ProgressMeter& ended);
    /// Clears the bars, so that something else can be printed at the beginning of a line; show() draws them
    /// again.
    void clear_for_output();

  private:
    std::string line(const ProgressMeter& meter) const;
    void print_tenths(std::span<ProgressMeter* const> running);
    void repeat();

    LiveLines lines;
    std::size_t name_columns;
    std::chrono::milliseconds idle;
    std::chrono::steady_clock::time_point last_shown, begun;
    std::mutex mutex;                  ///< guards `records`
    std::vector<std::string> records;  ///< last texts of all running tasks; only without a terminal
    std::optional<IdleTimer> timer;    ///< destroyed first, since its thread reads the members above
};

}  // namespace sherd
