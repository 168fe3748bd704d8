// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "fracture/step_report.h"

namespace sherd {

/// Shows on stderr how far a piece of work is: a bar that is drawn over itself on a terminal, else a line for
/// every tenth of it.
class Progress {
  public:
    /// total: all there is to do, in s of simulated time or in pieces.
    explicit Progress(double total);

    /// done: of the total; before and after: what is said beside the time to go.
    void show(double done, const std::string& before, const std::string& after = "");
    /// Of a run; cracks, halvings: until then.
    void update(const StepReport& report, std::size_t cracks, std::int64_t halvings);
    /// Ends the bar's line.
    void finish();

    double wall_seconds() const;

  private:
    double total;
    bool terminal;
    std::chrono::steady_clock::time_point start, last_shown;
    int tenths = 0;
};

}  // namespace sherd
