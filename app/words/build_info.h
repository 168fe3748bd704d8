// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// A program's origin, a line each without an end of line at the last: commit, compiler, libraries with their
/// versions.
std::string build_info();

}  // namespace sherd
