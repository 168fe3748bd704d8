// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>

namespace sherd {

/// Returns the values of a TOML table, and of all tables and arrays in it, as text by dotted keys such as
/// "load[1].force".
std::map<std::string, std::string> settings_of(const toml::table& table);

}  // namespace sherd
