// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

void read_join(TomlTable& table, const KeyInfo& key, MeshFile& mesh);
void read_size(TomlTable& table, const KeyInfo& key, MeshFile& mesh);

/// The keys of a mesh from a file, whether of a sheet or of an obstacle.
inline constexpr std::array mesh_file_keys{
    key<&MeshFile::path>("file", "an OBJ, PLY, OFF or STL file",
                         {.what = "the name of a mesh file", .required = true}),
    key<&MeshFile::repair>("repair",
                           "mend what can only mean one thing, with a warning; `false` makes an error of it"),
    special_key("join", Form::flag | Form::number,
                "`true`: make one vertex of points at exactly the same place; or within so many m",
                {.unit = "m", .range = positive, .otherwise = "`false`"}, read_join),
    key<&MeshFile::scale>("scale", "metres per unit of the file",
                          {.unit = "m per unit of the file", .range = positive}),
    special_key(
        "size", Form::number, "largest extent: the longest side of its bounding box in the file",
        {.unit = "m, the largest extent", .range = positive, .otherwise = "as it is", .excludes = {"scale"}},
        read_size)};

/// Reads `mesh` of a sheet: the name of a file, or a table of one of several kinds.
void read_mesh(TomlTable& table, const KeyInfo& key, SheetSpec& sheet);
std::vector<SectionText> inside_mesh();

}  // namespace sherd
