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

/// Shows on stderr how far pieces of work are that go on side by side: on a terminal a bar for each, drawn
/// over itself, else a line for every tenth of each, and one when nothing was printed for `idle`.
class ProgressDisplay {
  public:
    /// name_columns: how long the longest name is.
    explicit ProgressDisplay(std::size_t name_columns = 0,
                             std::chrono::milliseconds idle = std::chrono::seconds(30))
        : name_columns(name_columns), idle(idle) {}

    /// The work begins: how far it is may be shown late.
    void begin();
    /// Of all that go on; on a terminal not more often than it is worth it, unless `at_once`.
    void show(std::span<ProgressMeter* const> running, bool at_once = false);
    /// Leaves a last line of a piece of work that has ended, above those that go on. Only on a terminal: for
    /// a file its tenths say as much.
    void leave(const ProgressMeter& ended);
    /// Makes way for something else to be printed, at the beginning of a line; show() brings the bars back.
    void make_way();

  private:
    std::string line(const ProgressMeter& meter) const;
    void print_tenths(std::span<ProgressMeter* const> running);
    void repeat();

    LiveLines lines;
    std::size_t name_columns;
    std::chrono::milliseconds idle;
    std::chrono::steady_clock::time_point last_shown, begun;
    std::mutex mutex;                  ///< guards the records
    std::vector<std::string> records;  ///< last known of all that go on; where there is no terminal
    std::optional<IdleTimer> timer;    ///< destroyed first, since it reads the others
};

}  // namespace sherd
