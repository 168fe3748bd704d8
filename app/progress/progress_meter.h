// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "app/progress/progress_line.h"

namespace sherd {

/// Texts before and after the remaining time.
struct ProgressText {
    std::vector<ProgressPart> before, after;
};

/// Progress of a task, and its remaining time.
class ProgressMeter {
  public:
    /// total: all the work, in s of simulated time or in pieces; begun: the part that is done already.
    explicit ProgressMeter(double total, std::string name = "", double begun = 0);

    /// amount: done until now, of the total.
    void update(double amount, ProgressText text);
    /// Ends the task: its duration takes the place of the remaining time.
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
