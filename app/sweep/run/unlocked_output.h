// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace sherd {

/// Waits until no program holds the lock of an output: when a sweep is killed, its runs end after their
/// current step, and a task of Slurm that is cancelled waits for them. Throws Error (input) as OutputLock
/// does if that takes more than a minute.
void wait_until_unlocked(const std::filesystem::path& output);

}  // namespace sherd
