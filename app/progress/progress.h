// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/progress/progress_display.h"

namespace sherd {

/// Shows the progress of the program's single task on stderr. The destructor ends the line.
class Progress {
  public:
    /// total: all the work, for example simulated time in s or a number of pieces; begun: the part of it that
    /// has been done before.
    explicit Progress(double total, double begun = 0) : meter(total, "", begun) {}
    ~Progress() { finish(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Starts the display, so that something is printed even if the first show() is late.
    void begin() { display.begin(); }
    /// Shows the progress. amount: the part of the total that is done now.
    void show(double amount, ProgressText text);
    void show(double amount, const std::string& what) { show(amount, {{{what, 1}}, {}}); }
    /// Clears the line, so that something else can be printed.
    void clear_for_output() { display.clear_for_output(); }
    /// Ends the task, and leaves its last line in place.
    void finish();

    double wall_seconds() const { return meter.wall_seconds(); }

  private:
    ProgressMeter meter;
    ProgressDisplay display;
    bool shown = false;  ///< whether a line is shown that is not finished
};

}  // namespace sherd
