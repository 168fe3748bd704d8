// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "app/progress/progress_line.h"

namespace sherd {

/// Texts before and after the remaining time in a progress line.
struct ProgressText {
    std::vector<ProgressPart> before, after;
};

/// Progress of a task, and its estimated remaining time.
class ProgressMeter {
  public:
    /// total: all the work, for example simulated time in s or a number of pieces; begun: the part of it that
    /// has been done before.
    explicit ProgressMeter(double total, std::string name = "", double begun = 0);

    /// amount: the part of the total that is done now.
    void update(double amount, ProgressText text);
    /// Ends the task: its duration takes the place of the remaining time. how: word before the duration.
    void end(const std::string& how = "took");

    const ProgressStatus& status() const { return current; }
    /// Whether another tenth of the work has been done since the last call.
    bool has_new_tenth();
    double wall_seconds() const;

  private:
    void set_parts(const std::string& clock);

    double total, begun;
    std::chrono::steady_clock::time_point start;
    ProgressStatus current;
    ProgressText text;
    int tenths = 0;
};

}  // namespace sherd
