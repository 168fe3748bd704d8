// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/study/slurm_options.h"

namespace sherd {

/// Estimated time and memory of a row.
struct RowCost {
    double seconds = 0, memory = 0;  ///< s; bytes
};

/// Contents of a job array.
struct SlurmJob {
    std::size_t chunk = 1;           ///< number of rows of a task; the rows of task i begin at i * chunk
    std::vector<std::size_t> tasks;  ///< indices of tasks with rows to run
    int jobs = 1;                    ///< number of rows that a task runs at a time
    std::vector<std::string> sweep;  ///< command line of a task, without --jobs and --rows
};

/// Returns the script for sbatch. If the options have no time or memory, these follow from the cost. The time
/// is five times the cost of the rows that run one after the other, since contact and cracks make steps
/// longer than the first ones. The memory is 1.5 times the cost plus 300 MB, for each row that runs at a
/// time.
std::string slurm_script(const SlurmJob& job, const SlurmOptions& options, const RowCost& cost,
                         const std::filesystem::path& folder);

/// Returns the number of rows of a task: so many that, by the cost, the task ends within an hour, or more if
/// there would be more than 1000 tasks. rows: number of rows of the study.
std::size_t chunk_size(std::size_t rows, const RowCost& cost);

/// Throws Error (input) when a job of this folder is in the queue.
void require_no_job(const std::filesystem::path& folder);

/// Writes the script into the folder and submits it by sbatch; returns the number of the job. chunk:
/// SlurmJob::chunk, which is stored with the number. Throws Error (run) if sbatch fails or is missing.
std::string submit(std::size_t chunk, const std::string& script, const std::filesystem::path& folder);

/// The job that was submitted last from a folder.
struct SubmittedJob {
    std::string number;
    std::size_t chunk = 1;
    std::map<std::size_t, std::string> tasks;  ///< state of each task that is in the queue, such as "RUNNING"
};
/// Returns the job that was submitted last from the folder; none if no job was. If squeue is missing, the job
/// has no tasks.
std::optional<SubmittedJob> submitted_job(const std::filesystem::path& folder);

}  // namespace sherd
