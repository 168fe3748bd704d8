// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>

#include <string>
#include <vector>

#include "app/child_process.h"
#include "app/progress/progress_meter.h"
#include "app/scene/scene.h"

namespace sherd {

/// A variant that is being run.
class VariantRun {
  public:
    VariantRun(const Scene& scene, std::vector<std::string> arguments);

    /// Its pipes that may have something to say.
    void add_pipes(std::vector<pollfd>& pipes) const;
    /// Reads what there is in its pipes, its progress into the meter. Returns false when there will be no
    /// more.
    bool listen();
    /// What it has said on stderr since this was asked last, in whole lines with its name in front; at its
    /// end all.
    std::string take_words();
    /// Waits for its end; returns its exit code.
    int finish();
    void interrupt() { process.interrupt(); }

    std::string variant;
    ProgressMeter meter;
    std::string results;  ///< stdout

  private:
    bool is_open() const { return out_open || err_open || reports_open; }
    void read_reports();

    ChildProcess process;
    std::string words, reports;
    bool out_open = true, err_open = true, reports_open = true;
};

}  // namespace sherd
