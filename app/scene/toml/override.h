// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace sherd {

/// Puts `assignment`, KEY=VALUE of the command line, into `scene`. KEY is dotted; VALUE is TOML, and a bare
/// word that is not TOML is a string. Added keys have the source path "--set KEY=VALUE". Throws Error when
/// the assignment cannot be understood.
void apply_override(toml::table& scene, const std::string& assignment);

/// Puts the keys of `from` into `into`. Tables named by a dotted key or a header are merged, and everything
/// else, inline tables too, is replaced.
void merge_keys(toml::table& into, toml::table&& from);

/// Whether a source path is that of an override.
bool is_override(std::string_view source_path);

}  // namespace sherd
