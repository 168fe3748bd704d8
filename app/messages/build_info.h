// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns the origin of the program, a line each, without a newline at the end: commit, compiler, libraries
/// with their versions.
std::string build_info();

}  // namespace sherd
