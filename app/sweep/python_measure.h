// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Throws Error (input) unless a Python file runs and has a function `measure`. Asked before the runs, it
/// spares hours of them.
void require_measure(const std::filesystem::path& file);

/// Arguments of python3 that print what the function `measure(recording)` of a Python file says of a
/// recording, as JSON in the last line. It gets a sherd.Recording; what it prints itself goes to stderr.
std::vector<std::string> python_arguments(const std::filesystem::path& file,
                                          const std::filesystem::path& recording);

/// The numbers that were printed; what is None or no finite number is left out. Throws Error (run) when it
/// was something else.
std::vector<std::pair<std::string, double>> python_values(const std::string& printed);

}  // namespace sherd
