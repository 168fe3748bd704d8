// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "app/run/run_observer.h"

namespace sherd {

/// Load factors of a run's steps: the last, the largest, and the limit load.
struct LoadHistory {
    double last = 0, largest = 0;
    std::optional<double> limit = {};  ///< load factor before its first decrease; none: it has never
                                       ///< decreased

    void add(double load) {
        if (!limit && load < last) limit = last;
        last = load;
        largest = std::max(largest, load);
    }
};

/// Totals and extreme values over the steps of a run.
class RunTotals : public RunObserver {
  public:
    void stepped(const StepReport& report, const CrackEvents& events) override;

    void visit_state(StateVisitor& visit) {
        auto& [cracks, capped, newton_iterations, halvings, smallest_step, explicit_time, urgencies, load,
               peaks, yielded_at, largest_energy, last] = *this;
        visit(cracks, capped, newton_iterations, halvings, smallest_step, explicit_time, urgencies, load,
              peaks, yielded_at, largest_energy, last);
    }

    std::size_t cracks = 0, capped = 0;
    std::int64_t newton_iterations = 0, halvings = 0;
    double smallest_step = std::numeric_limits<double>::infinity();  ///< s
    double explicit_time = 0;                                        ///< s, simulated time of explicit steps
    std::array<std::int64_t, urgency_count> urgencies{};             ///< number of steps with each urgency
    LoadHistory load;
    StepReport peaks;
    /// Time, s, at which a material first exceeded its yield stress; infinite if none did.
    double yielded_at = std::numeric_limits<double>::infinity();
    double largest_energy = 0;  ///< J, largest sum of kinetic, elastic and contact energy
    StepReport last;
};

}  // namespace sherd
