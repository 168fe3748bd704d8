// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// A process that was ended by a signal has the exit code signal_base plus the number of the signal, as in
/// shells.
constexpr int signal_base = 128;

/// Returns the exit code of a process. status: as reported by waitpid().
int exit_code_of(int status);

}  // namespace sherd
