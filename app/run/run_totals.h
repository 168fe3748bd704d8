// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "app/run/load_history.h"
#include "app/run/run_observer.h"

namespace sherd {

/// Adds up what a run does in its steps.
class RunTotals : public RunObserver {
  public:
    void stepped(const StepReport& report, const CrackEvents& events) override;

    void visit_state(StateVisitor& visit) {
        auto& [cracks, capped, newton_iterations, halvings, smallest_step, load, peaks, last] = *this;
        visit(cracks, capped, newton_iterations, halvings, smallest_step, load, peaks, last);
    }

    std::size_t cracks = 0, capped = 0;
    std::int64_t newton_iterations = 0, halvings = 0;
    double smallest_step = std::numeric_limits<double>::infinity();  ///< s
    LoadHistory load;
    StepReport peaks;
    StepReport last;
};

}  // namespace sherd
