// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "app/scene/toml_table.h"
#include "meshops/mesh.h"

namespace sherd {

/// Reads the keys that meshes from files have in common: file, repair, join, scale.
MeshFile read_mesh_file(TomlTable& table, const std::filesystem::path& directory);

/// The mesh of a file, scaled; not remeshed. Throws Error; warnings begin with the file.
Mesh read_mesh(const MeshFile& spec, std::vector<std::string>& warnings);

/// The mesh of a sheet before it is placed: generated (with the scene's seed), or read, scaled and remeshed.
/// Throws Error naming the scene's line and key. Warnings are sentences that name the sheet's mesh.
Mesh make_unplaced_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings);

/// The same where the scene places it.
Mesh make_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings);

/// Whether a selection holds a vertex; one without box, boundary and group holds all.
bool selects(const Selection& selection, const Mesh& placed, Vertex v);

/// Throws Error, naming the scene's line and key, when the selection's group is none of `known`, the groups
/// of the meshes that it selects from.
void check_group(const Selection& selection, const std::vector<std::string>& known);

/// Numbers of the vertices that the sheet's pins and clamps hold, in ascending order. Throws Error on one
/// that holds none.
std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

}  // namespace sherd
