// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <list>
#include <vector>

#include "app/progress/progress_display.h"
#include "app/sweep/result_journal.h"
#include "app/sweep/row_run.h"

namespace sherd {

/// Runs rows of a study side by side, each in a process of its own, and shows how far all are.
class SweepRunner {
  public:
    /// wanted: numbers of the rows to run. known: of them and of others, for the progress. All must outlive
    /// this.
    SweepRunner(const Study& study, const StudyRows& rows, std::filesystem::path folder,
                std::vector<std::size_t> wanted, int jobs);

    /// Appends the result of each row that comes to its end. After an interruption rows are ended, of which
    /// those that did not end well by themselves have no result.
    void run(ResultJournal& journal);
    bool stopped = false;  ///< an interruption has ended them

  private:
    void start_some();
    void wait_for_output() const;
    void listen(ResultJournal& journal);
    void show();
    void stop();

    const Study& study;
    const StudyRows& rows;
    std::filesystem::path folder;
    std::vector<std::size_t> wanted;
    int jobs, threads;
    std::list<RowRun> running;
    std::size_t next = 0;  ///< of `wanted`
    std::size_t done = 0, failed = 0;
    ProgressDisplay display;
    ProgressMeter meter;
};

}  // namespace sherd
