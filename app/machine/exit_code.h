// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Exit codes of what a signal has ended are this and the signal, as shells have it.
constexpr int signal_base = 128;

/// The exit code of a process whose end has this status (waitpid).
int exit_code_of(int status);

}  // namespace sherd
