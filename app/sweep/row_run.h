// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/process/child_run.h"
#include "app/sweep/row_result.h"
#include "app/sweep/study_row.h"

namespace sherd {

/// Where the recording of a row is, or was: FOLDER/runs/IDENTITY.h5.
std::filesystem::path row_recording(const std::filesystem::path& folder, const StudyRow& row);

/// A row that is being run, and then measured.
class RowRun {
  public:
    /// Goes on from the checkpoint that a killed run of it has left, unless another program wrote that.
    RowRun(const Study& study, const StudyRows& rows, const StudyRow& row,
           const std::filesystem::path& folder, int threads);

    void add_pipes(std::vector<pollfd>& pipes) const { process->add_pipes(pipes); }
    /// Reads what its process says. Returns false when all has come to its end.
    bool listen();
    void interrupt() { process->interrupt(); }
    /// After its end. Leaves the recording if the study keeps it, or if the process was killed.
    RowResult finish();
    double done() const { return process->meter.status().done; }  ///< 0 to 1

  private:
    void end_process();
    void measure();

    const Study& study;
    const StudyRows& rows;
    std::filesystem::path recording;
    std::optional<ChildRun> process;
    bool measuring = false;  ///< the process is the study's Python file
    std::string words;       ///< its stderr
    RowResult result;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

}  // namespace sherd
