// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Returns the names of the `[[variant]]`s of a scene, in the order of the file. A variant without a name,
/// with one that does not do as a part of a file's name, or with that of another one, is a problem.
std::vector<std::string> read_variant_names(TomlTable& root);

/// Takes the variants out of `scene` and lets the keys of the one called `name` replace those of the scene.
/// Tables are merged, and everything else, inline tables and arrays too, is replaced. Nothing replaces
/// anything when no variant has that name.
void apply_variant(toml::table& scene, const std::string& name);

}  // namespace sherd
