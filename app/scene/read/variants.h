// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Returns the names of the `[[variant]]`s of a scene, in the order of the file. A missing name, one that
/// cannot be part of a file's name, or one that another variant has, is a problem.
std::vector<std::string> read_variant_names(TomlTable& root);

/// Removes the variants from `scene`, and replaces its keys by those of the variant `name`, if there is one.
/// Tables are merged; everything else, inline tables and arrays too, is replaced.
void apply_variant(toml::table& scene, const std::string& name);

}  // namespace sherd
