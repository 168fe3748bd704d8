// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshops/line_cut.h"

namespace sherd {

/// Reads polylines from a text file with a point per line as x y z, m; a blank line begins another polyline.
/// A # starts a comment. Points are named by file and line. Throws Error with file and line on a line that is
/// not three finite numbers, on a polyline of one point, and on a file that is missing or has no point.
std::vector<std::vector<LinePoint>> read_cut_lines(const std::filesystem::path& file);

}  // namespace sherd
