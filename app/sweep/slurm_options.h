// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace sherd {

/// What Slurm is asked for; empty or 0: by estimate, or Slurm's own default.
struct SlurmOptions {
    std::string partition, account;
    std::string time;       ///< of a task, as sbatch takes it
    std::string memory;     ///< the same
    std::size_t chunk = 0;  ///< rows a task
};

}  // namespace sherd
