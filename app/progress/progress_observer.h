// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/progress/run_reporter.h"
#include "app/run/run_observer.h"
#include "app/run/run_totals.h"
#include "app/scene/scene.h"

namespace sherd {

/// Shows or reports how far a run is, and says once why its steps take long, where it is seen.
class ProgressObserver : public RunObserver {
  public:
    /// begun: s of the scene that earlier runs have made; totals: of the run, which are told of each step
    /// before this is; descriptor: as for RunReporter, which may throw.
    ProgressObserver(const Scene& scene, double begun, const RunTotals& totals, int descriptor)
        : reporter(scene.duration, begun, descriptor), scene(scene), totals(totals) {}

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void ended(const RunEnd& end) override;

  private:
    void warn_of_substeps(const StepReport& report);

    RunReporter reporter;
    const Scene& scene;
    const RunTotals& totals;
    bool warned = false;  ///< whether many substeps have been warned of
};

}  // namespace sherd
