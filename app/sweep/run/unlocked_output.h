// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace sherd {

/// Waits until no program holds the lock of an output. The runs of a killed sweep, or of a cancelled task of
/// Slurm, hold the lock until their current step has ended. Throws Error (input) as OutputLock does if that
/// takes more than a minute.
void wait_until_unlocked(const std::filesystem::path& output);

}  // namespace sherd
