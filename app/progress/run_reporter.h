// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/progress/progress.h"
#include "app/progress/run_progress.h"

namespace sherd {

/// Tells how far a run is: on stderr, or to the process that started this one and shows it among others.
class RunReporter {
  public:
    /// duration: s; begun: s of it that earlier runs have made; descriptor: of the other process's pipe,
    /// negative: there is only stderr. Throws Error (input) when that is not open.
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

}  // namespace sherd
