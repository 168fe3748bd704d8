// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/process/child_run.h"
#include "app/sweep/run/row_result.h"
#include "app/sweep/study/study_row.h"

namespace sherd {

/// Returns the path of a row's recording, which may not exist: FOLDER/runs/IDENTITY.h5.
std::filesystem::path row_recording(const std::filesystem::path& folder, const StudyRow& row);

/// A row of a study that is run in a child process and then measured, also in a child process if the study
/// has a Python file.
class RowRun {
  public:
    /// Starts the run, or resumes it from the checkpoint that a killed run has left, unless another program
    /// wrote the checkpoint. study, rows: must outlive this object.
    RowRun(const Study& study, const StudyRows& rows, const StudyRow& row,
           const std::filesystem::path& folder, int threads);

    void add_pipes(std::vector<pollfd>& pipes) const { process->add_pipes(pipes); }
    /// Reads the output of the present process. Returns false when both the run and the measurement have
    /// ended.
    bool listen();
    void interrupt() { process->interrupt(); }
    /// Returns the result; must be called after listen() has returned false. Keeps the recording if the study
    /// asks for it, or if the process was killed.
    RowResult finish();
    double done() const { return process->meter.status().done; }  ///< progress of `process`, 0 to 1

  private:
    void end_process();
    void measure();

    const Study& study;
    const StudyRows& rows;
    std::filesystem::path recording;
    std::optional<ChildRun> process;
    bool measuring = false;  ///< whether the process runs the study's Python file
    std::string words;       ///< stderr of the process
    RowResult result;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

}  // namespace sherd
