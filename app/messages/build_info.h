// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns what the program is built from, in three lines without a newline at the end: commit, compiler,
/// libraries with their versions.
std::string build_info();

}  // namespace sherd
