// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// From now on Ctrl-C and SIGTERM do not end the program, but make interrupted() true.
void watch_for_interruption();
bool interrupted();

}  // namespace sherd
