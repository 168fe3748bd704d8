// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Throws Error (input) unless a Python file runs and has a function `measure`. To be called before the runs,
/// which may take hours.
void require_measure(const std::filesystem::path& file);

/// Returns the arguments of python3 that call the function `measure(recording)` of a Python file with a
/// sherd.Recording, and print its result as JSON in the last line; output of the file itself goes to stderr.
std::vector<std::string> python_arguments(const std::filesystem::path& file,
                                          const std::filesystem::path& recording);

/// Returns the numbers that were printed, without those that are None. Throws Error (run) if the text is no
/// JSON object, as with NaN in it, or if the name of a number is that of another column.
std::vector<std::pair<std::string, double>> python_values(const std::string& printed);

}  // namespace sherd
