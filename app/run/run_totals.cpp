// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/run_totals.h"

#include <algorithm>

namespace sherd {

void RunTotals::stepped(const StepReport& report, const CrackEvents& events) {
    cracks += events.failures.size();
    halvings += report.halvings;
    smallest_step = std::min(smallest_step, report.step_size);
    if (report.is_explicit) explicit_time += report.step_size;
    ++urgencies[static_cast<std::size_t>(report.urgency)];
    load.add(report.load);
    capped += report.stage_cap_reached;
    newton_iterations += report.newton_iterations;
    raise_peaks(peaks, report);
    largest_energy =
        std::max(largest_energy, report.kinetic + report.bending + report.membrane + report.contact);
    if (report.peak_yield > 1) yielded_at = std::min(yielded_at, report.time);
    last = report;
}

}  // namespace sherd
