// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Makes Ctrl-C and SIGTERM end the program at once, with a message on stderr and the exit code that shells
/// use for a program that a signal ended.
void end_on_interruption();

/// Makes the first Ctrl-C or SIGTERM set interrupted(), and a second one end the program at once.
void watch_for_interruption();
bool interrupted();
/// Returns the exit code of a program that ends because of interrupted(): 130 after Ctrl-C, 143 after
/// SIGTERM.
int interruption_exit_code();

/// To be called in a child process of this program. The child then ignores Ctrl-C, which a terminal sends to
/// parent and child; the parent passes it on as SIGTERM. The child also gets SIGTERM when the parent ends.
void leave_interruption_to_parent();

}  // namespace sherd
