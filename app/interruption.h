// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// From here on, Ctrl-C (SIGINT) and SIGTERM no longer end the program: they are noted.
void catch_interruption();

/// Whether such a signal has come since.
bool interrupted();

}  // namespace sherd
