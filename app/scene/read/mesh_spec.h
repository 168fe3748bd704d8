// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/scene/mesh_spec.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads `mesh = { generate = ... }` and expands plates and bowls to profiles.
GeneratedMesh read_shape(TomlTable& table);

/// Reads the keys that meshes from files have in common: file, repair, join, scale, size.
MeshFile read_mesh_file(TomlTable& table, const std::filesystem::path& directory);

}  // namespace sherd
