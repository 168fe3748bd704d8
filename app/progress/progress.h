// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/progress/progress_display.h"

namespace sherd {

/// Shows on stderr how far the one thing is that the program does. Its line is ended with it.
class Progress {
  public:
    /// total: all there is to do, in s of simulated time or in pieces; begun: what of it is done already.
    explicit Progress(double total, double begun = 0) : meter(total, "", begun) {}
    ~Progress() { finish(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The work begins: what there is to show() may come late.
    void begin() { display.begin(); }
    /// amount: of the total.
    void show(double amount, ProgressText text);
    void show(double amount, const std::string& what) { show(amount, {{{what, 1}}, {}}); }
    /// Makes way for something else to be printed.
    void make_way() { display.make_way(); }
    /// Leaves the line as it is in the end.
    void finish();

    double wall_seconds() const { return meter.wall_seconds(); }

  private:
    ProgressMeter meter;
    ProgressDisplay display;
    bool shown = false;  ///< and not finished
};

}  // namespace sherd
