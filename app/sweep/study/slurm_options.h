// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace sherd {

/// Options of Slurm; empty or 0: by estimate, or Slurm's own default.
struct SlurmOptions {
    std::string partition, account;
    std::string time;       ///< time of a task, as sbatch reads it
    std::string memory;     ///< memory of a task, as sbatch reads it
    std::size_t chunk = 0;  ///< rows of a task
};

}  // namespace sherd
