// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <list>
#include <vector>

#include "app/progress/progress_display.h"
#include "app/sweep/run/result_journal.h"
#include "app/sweep/run/row_run.h"

namespace sherd {

/// Runs rows of a study concurrently, each in a child process, and shows their progress.
class SweepRunner {
  public:
    /// wanted: indices of the rows to run; jobs: number of rows to run at a time. study and rows must outlive
    /// this object.
    SweepRunner(const Study& study, const StudyRows& rows, std::filesystem::path folder,
                std::vector<std::size_t> wanted, int jobs);

    /// Runs the rows, and appends the result of each row that ends to the journal. An interruption ends the
    /// rows; rows that it cuts short have no result.
    void run(ResultJournal& journal);
    bool stopped = false;  ///< whether an interruption has ended run() early

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
    std::size_t next = 0;  ///< index in `wanted` of the next row to start
    std::size_t done = 0, failed = 0;
    ProgressDisplay display;
    ProgressMeter meter;
};

}  // namespace sherd
