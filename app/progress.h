// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "fracture/step_report.h"

namespace sherd {

/// Shows on stderr how far a run is: a bar that is drawn over itself on a terminal, else a line for every
/// tenth of the duration.
class Progress {
  public:
    /// duration: s of simulated time.
    explicit Progress(double duration);

    /// cracks, halvings: until then.
    void update(const StepReport& report, std::size_t cracks, std::int64_t halvings);
    /// Ends the bar's line.
    void finish();

    double wall_seconds() const;

  private:
    std::string status(const StepReport& report, std::size_t cracks, std::int64_t halvings) const;

    double duration;
    bool terminal;
    std::chrono::steady_clock::time_point start, last_shown;
    int tenths = 0;
};

}  // namespace sherd
