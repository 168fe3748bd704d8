// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/progress/progress.h"
#include "app/progress/run_progress.h"
#include "app/run/run_observer.h"
#include "app/run/run_totals.h"
#include "app/scene/scene.h"

namespace sherd {

/// Shows the progress of a run on stderr, or reports it to the process that started this one.
class RunReporter {
  public:
    /// duration: s; begun: s of it that earlier runs have simulated; descriptor: of the pipe to the other
    /// process, negative: stderr only. Throws Error (input) if the descriptor is not open.
    RunReporter(double duration, double begun, int descriptor);

    void update(const RunProgress& progress);
    /// Prints a warning above the line.
    void warn(const std::string& words);
    /// Ends the line on stderr, or reports for the last time.
    void finish();
    double wall_seconds() const { return shown.wall_seconds(); }

  private:
    void send() const;

    Progress shown;
    ProgressMeter sent;
    RunProgress last;
    int descriptor;
    double last_sent = 0;  ///< s, of wall_seconds()
};

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
