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
    double seconds = 0, memory = 0;  ///< s, bytes
};

/// Contents of a job array.
struct SlurmJob {
    std::size_t chunk = 1;           ///< rows of a task: those of task i begin at i * chunk
    std::vector<std::size_t> tasks;  ///< indices of tasks with rows to run
    int jobs = 1;                    ///< rows at a time in each task
    std::vector<std::string> sweep;  ///< command line of a task without its rows
};

/// Returns the script for sbatch. Time and memory that the options do not have are several times the cost,
/// since contact and cracks make steps longer than the first ones.
std::string slurm_script(const SlurmJob& job, const SlurmOptions& options, const RowCost& cost,
                         const std::filesystem::path& folder);

/// Returns the number of rows of a task, by the cost: such that it ends within an hour, and that there are at
/// most 1000 tasks.
std::size_t chunk_size(std::size_t rows, const RowCost& cost);

/// Throws Error (input) when a job of this folder is in the queue.
void require_no_job(const std::filesystem::path& folder);

/// Writes the script into the folder and submits it by sbatch; returns the number of the job. Throws Error
/// (run) if sbatch fails or is missing.
std::string submit(std::size_t chunk, const std::string& script, const std::filesystem::path& folder);

/// The job of the folder that was submitted last.
struct SubmittedJob {
    std::string number;
    std::size_t chunk = 1;
    std::map<std::size_t, std::string> tasks;  ///< tasks in the queue, with their state: "RUNNING"
};
/// Returns the job that was submitted last; none if there is none. Without squeue no task is in the queue.
std::optional<SubmittedJob> submitted_job(const std::filesystem::path& folder);

}  // namespace sherd
