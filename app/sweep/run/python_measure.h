// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Throws Error (input) unless a Python file runs and has a function `measure`. Must be called before the
/// runs of a sweep, which may take hours.
void require_measure(const std::filesystem::path& file);

/// Returns arguments with which python3 calls the function `measure(recording)` of a Python file with a
/// sherd.Recording, and prints the result as a line of JSON. Output of the file itself goes to stderr.
std::vector<std::string> python_arguments(const std::filesystem::path& file,
                                          const std::filesystem::path& recording);

/// Returns the names and numbers in `printed`, the output of such a call, without those that are None. Throws
/// Error (run) if the output is no JSON object, as with NaN in it, or if a name is that of another column of
/// the table.
std::vector<std::pair<std::string, double>> python_values(const std::string& printed);

}  // namespace sherd
