// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/progress/progress_display.h"

namespace sherd {

/// Shows the progress of the program's single task on stderr. The destructor ends the line.
class Progress {
  public:
    /// total: all the work, in s of simulated time or in pieces; begun: the part that is done already.
    explicit Progress(double total, double begun = 0) : meter(total, "", begun) {}
    ~Progress() { finish(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Starts the display; the first show() may be late.
    void begin() { display.begin(); }
    /// amount: done until now, of the total.
    void show(double amount, ProgressText text);
    void show(double amount, const std::string& what) { show(amount, {{{what, 1}}, {}}); }
    /// Clears the line, so that something else can be printed.
    void clear_for_output() { display.clear_for_output(); }
    /// Leaves the last line in place.
    void finish();

    double wall_seconds() const { return meter.wall_seconds(); }

  private:
    ProgressMeter meter;
    ProgressDisplay display;
    bool shown = false;  ///< whether a line is shown that is not finished
};

}  // namespace sherd
