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
    /// duration: simulated time of the whole run, s; begun: the part of it that earlier runs have simulated,
    /// s; descriptor: file descriptor of the pipe to the other process, or negative to show the progress on
    /// stderr. Throws Error (input) if the descriptor is not open.
    RunReporter(double duration, double begun, int descriptor);

    void update(const RunProgress& progress);
    /// Prints a warning above the progress line.
    void warn(const std::string& words);
    /// Ends the progress line on stderr, or sends a last report.
    void finish();
    double wall_seconds() const { return shown.wall_seconds(); }

  private:
    void send() const;

    Progress shown;
    ProgressMeter sent;
    RunProgress last;
    int descriptor;
    double last_sent = 0;  ///< s, wall_seconds() of the last report
};

/// Shows or reports the progress of a run, and warns once, of the first step with many substeps.
class ProgressObserver : public RunObserver {
  public:
    /// begun: the part of the scene's duration that earlier runs have simulated, s; totals: totals of the
    /// run, which must observe each step before this object does; descriptor: as for RunReporter, whose
    /// constructor may throw Error.
    ProgressObserver(const Scene& scene, double begun, const RunTotals& totals, int descriptor)
        : reporter(scene.duration, begun, descriptor), scene(scene), totals(totals) {}

    void stepped(const StepReport& report, const CrackEvents& events) override;
    void ended(const RunEnd& end) override;

  private:
    void warn_of_substeps(const StepReport& report);

    RunReporter reporter;
    const Scene& scene;
    const RunTotals& totals;
    bool warned = false;  ///< whether the warning has been printed
};

}  // namespace sherd
