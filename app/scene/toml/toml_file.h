// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace sherd {

/// Reads the text of a TOML file. kind: noun for the file in messages, "scene" or "study". Throws Error with
/// the reason when it cannot be read.
std::string read_toml_text(const std::filesystem::path& file, std::string_view kind);

/// Parses `text`, the content of `file`, into a table whose source path is `file`. Throws Error with line and
/// column when it is not TOML.
toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

}  // namespace sherd
