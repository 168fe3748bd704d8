// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace sherd {

/// Puts `assignment`, KEY=VALUE from the command line, into `scene`. KEY is dotted; VALUE is TOML, or a
/// string without quotes. Added keys have the source path "--set KEY=VALUE". Throws Error when the assignment
/// cannot be understood.
void apply_override(toml::table& scene, const std::string& assignment);

/// Puts the keys of `from` into `into`. A table of `from` that is not inline is merged into a table that
/// `into` has; any other value, an inline table too, replaces the value that `into` has.
void merge_keys(toml::table& into, toml::table&& from);

/// Whether a source path belongs to a key that apply_override() has added.
bool is_override(std::string_view source_path);

}  // namespace sherd
