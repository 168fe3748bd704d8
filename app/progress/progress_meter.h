// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "app/progress/progress_line.h"

namespace sherd {

/// What is said before and after the time to go.
struct ProgressText {
    std::vector<ProgressPart> before, after;
};

/// How far a piece of work is, and how long it will take.
class ProgressMeter {
  public:
    /// total: all there is to do, in s of simulated time or in pieces; begun: what of it is done already.
    explicit ProgressMeter(double total, std::string name = "", double begun = 0);

    /// amount: of the total.
    void update(double amount, ProgressText text);
    /// The work has ended: the time that it took stands in the place of the time to go.
    void end(const std::string& how = "took");

    const ProgressStatus& status() const { return current; }
    /// Whether another tenth of the work has been done since this was asked last.
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
