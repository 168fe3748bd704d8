// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/slurm_options.h"

namespace sherd {

/// What a row is likely to take, and the machine with it.
struct RowCost {
    double seconds = 0, memory = 0;  ///< s, bytes
};

/// What a job array does.
struct SlurmJob {
    std::size_t chunk = 1;           ///< rows a task: task i has those from i * chunk on
    std::vector<std::size_t> tasks;  ///< that have rows to run
    int jobs = 1;                    ///< rows at a time in each
    std::vector<std::string> sweep;  ///< command line of a task but for its rows
};

/// The script for sbatch. Time and memory that were not given are several times the cost, since contact and
/// cracks make steps longer than the first ones.
std::string slurm_script(const SlurmJob& job, const SlurmOptions& options, const RowCost& cost,
                         const std::filesystem::path& folder);

/// How many rows a task has, by the cost: such that it ends within an hour, and that there are at most 1000.
std::size_t chunk_size(std::size_t rows, const RowCost& cost);

/// Throws Error (input) when a job of this folder is in the queue.
void require_no_job(const std::filesystem::path& folder);

/// Writes the script into the folder and hands it to sbatch; returns the number of the job. Throws Error
/// (run) when that says no or is not there.
std::string submit(std::size_t chunk, const std::string& script, const std::filesystem::path& folder);

/// The job of the folder that was submitted last.
struct SubmittedJob {
    std::string number;
    std::size_t chunk = 1;
    std::map<std::size_t, std::string> tasks;  ///< that are in the queue, with their state: "RUNNING"
};
/// None when nothing was submitted. Without squeue no task is in the queue.
std::optional<SubmittedJob> submitted_job(const std::filesystem::path& folder);

}  // namespace sherd
