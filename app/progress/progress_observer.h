// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "app/progress/run_reporter.h"
#include "app/run/run_observer.h"
#include "app/run/run_totals.h"

namespace sherd {

/// Shows or reports how far a run is.
class ProgressObserver : public RunObserver {
  public:
    /// duration, unit: of the scene; begun: s of it that earlier runs have made; totals: of the run, which
    /// are told of each step before this is; descriptor: as for RunReporter, which may throw.
    ProgressObserver(double duration, double begun, std::string unit, const RunTotals& totals, int descriptor)
        : reporter(duration, begun, descriptor), duration(duration), unit(std::move(unit)), totals(totals) {}

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void ended(const RunEnd& end) override;

  private:
    RunReporter reporter;
    double duration;
    std::string unit;
    const RunTotals& totals;
};

}  // namespace sherd
