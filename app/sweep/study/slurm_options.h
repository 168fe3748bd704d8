// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace sherd {

/// Options of Slurm. An empty time or memory, or a chunk of 0, is estimated; for an empty partition or
/// account Slurm has defaults.
struct SlurmOptions {
    std::string partition, account;
    std::string time;       ///< time of a task, as sbatch reads it
    std::string memory;     ///< memory of a task, as sbatch reads it
    std::size_t chunk = 0;  ///< number of rows of a task
};

}  // namespace sherd
