// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// From now on Ctrl-C and SIGTERM end the program at once, with a word on stderr and the exit code that a
/// shell gives a program that a signal ended.
void end_on_interruption();

/// From now on the first Ctrl-C or SIGTERM only makes interrupted() true; a second one ends the program.
void watch_for_interruption();
bool interrupted();
/// 130 after Ctrl-C, 143 after SIGTERM, for who ends because of interrupted().
int interruption_exit_code();

/// For a part of a program, which runs in a process of its own beside the first one: Ctrl-C, which a terminal
/// sends to both, is left to the first one, which passes it on as SIGTERM; and so is the end of the first
/// one.
void leave_interruption_to_parent();

}  // namespace sherd
