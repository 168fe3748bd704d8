// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/map_source.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads what a map of a sheet has its values from: one of `texture`, `vdb` (with `grid`) and `property`.
/// where: gets the place of that key. `directory` is where the names of files are understood from.
MapSource read_map_source(TomlTable& map, const std::filesystem::path& directory, std::string& where);

}  // namespace sherd
