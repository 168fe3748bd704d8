// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

void read_join(TomlTable& table, const KeyInfo& key, MeshFile& mesh);
void read_size(TomlTable& table, const KeyInfo& key, MeshFile& mesh);

/// Keys of a mesh from a file, for sheets and for obstacles.
inline constexpr std::array mesh_file_keys{
    key<&MeshFile::path>("file", "an OBJ, PLY, OFF or STL file",
                         {.what = "the name of a mesh file", .required = true}),
    key<&MeshFile::repair>("repair", "repair unambiguous defects, with a warning; `false` makes them errors"),
    special_key("join", Form::flag | Form::number,
                "`true`: merge vertices at exactly the same place; a number: also border vertices this near",
                {.unit = "m", .range = positive, .otherwise = "`false`"}, read_join),
    key<&MeshFile::scale>("scale", "metres per unit of the file",
                          {.unit = "m per unit of the file", .range = positive}),
    special_key("size", Form::number,
                "largest extent of the mesh: the longest side of its bounding box in the file",
                {.unit = "m, the largest extent",
                 .range = positive,
                 .otherwise = "as in the file",
                 .excludes = {"scale"}},
                read_size)};

/// Reads the key `mesh` of a sheet: the name of a file, or a table for a file, a generated shape or a mesh
/// that a program passes.
void read_mesh(TomlTable& table, const KeyInfo& key, SheetSpec& sheet);
std::vector<SectionText> inside_mesh();

}  // namespace sherd
