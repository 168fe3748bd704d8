// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads the key `name` of a table that describes a `thing`, "variant". The name consists of letters, digits,
/// _ and -, and differs from those in `earlier`. reason: for messages, "names a group of the recording".
std::string read_plain_name(TomlTable& table, std::string_view thing, std::string_view reason,
                            const std::vector<std::string>& earlier);

}  // namespace sherd
