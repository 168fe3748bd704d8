// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_observer.h"

namespace sherd {

void ProgressObserver::stepped(const StepReport& report, const CrackEvents&) {
    reporter.update({report.step, report.time, duration, report.step_size,
                     static_cast<std::int64_t>(totals.cracks), report.fragments, totals.halvings, unit});
}

void ProgressObserver::ended(const RunEnd& end) {
    // It may be the reader of the reports that is gone.
    if (!end.has_failed()) reporter.finish();
}

}  // namespace sherd
