// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Exit code of a process that a signal has ended, less the number of the signal, as in shells.
constexpr int signal_base = 128;

/// Returns the exit code of a process with this status (waitpid).
int exit_code_of(int status);

}  // namespace sherd
