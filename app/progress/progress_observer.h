// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/progress/run_reporter.h"
#include "app/run/run_observer.h"
#include "app/run/run_totals.h"
#include "app/scene/scene.h"

namespace sherd {

/// Shows or reports the progress of a run, and warns once of a step with many substeps.
class ProgressObserver : public RunObserver {
  public:
    /// begun: s of the scene that earlier runs have simulated; totals: of the run, which must observe each
    /// step before this does; descriptor: as for RunReporter, which may throw.
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
