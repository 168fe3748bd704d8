// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sherd {

/// Returns a word as it is to be typed in a shell, in quotes if necessary.
std::string shell_quoted(const std::string& word);

/// Returns a path in a form that no program takes for an option: "./-a.toml" for "-a.toml".
std::string path_argument(const std::filesystem::path& path);

}  // namespace sherd
