// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/progress/progress.h"
#include "app/progress/run_progress.h"

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

}  // namespace sherd
