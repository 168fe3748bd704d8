// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <span>
#include <string>

#include "app/progress/live_lines.h"
#include "app/progress/progress_meter.h"

namespace sherd {

/// Shows on stderr how far pieces of work are that go on side by side: on a terminal a bar for each, drawn
/// over itself, else a line for every tenth of each.
class ProgressDisplay {
  public:
    /// name_columns: how long the longest name is.
    explicit ProgressDisplay(std::size_t name_columns = 0) : name_columns(name_columns) {}

    /// Of all that go on; on a terminal not more often than it is worth it, unless `at_once`.
    void show(std::span<ProgressMeter* const> running, bool at_once = false);
    /// Leaves a last line of a piece of work that has ended, above those that go on. Only on a terminal: for
    /// a file its tenths say as much.
    void leave(const ProgressMeter& ended);
    /// Makes way for something else to be printed, at the beginning of a line; show() brings the bars back.
    void make_way();

  private:
    std::string line(const ProgressMeter& meter) const;

    LiveLines lines;
    std::size_t name_columns;
    std::chrono::steady_clock::time_point last_shown;
};

}  // namespace sherd
