// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>

namespace sherd {

/// The values of a TOML table and of the tables and arrays in it as text, by dotted keys ("load[1].force").
std::map<std::string, std::string> settings_of(const toml::table& table);

}  // namespace sherd
