// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sherd {

/// A word as a shell takes it, in quotes where it needs them.
std::string shell_word(const std::string& word);

/// A path as an argument that no program takes for an option: "./-a.toml".
std::string path_argument(const std::filesystem::path& path);

}  // namespace sherd
