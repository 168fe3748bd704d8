// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/strength_map.h"

namespace sherd {

void read_texture(TomlTable& table, const KeyInfo& key, MapSource& source);
void read_vdb(TomlTable& table, const KeyInfo& key, MapSource& source);
void read_grid(TomlTable& table, const KeyInfo& key, MapSource& source);
void read_property(TomlTable& table, const KeyInfo& key, MapSource& source);

/// Keys of a map over a sheet that say from where its values come.
inline constexpr std::array map_source_keys{
    special_key("texture", Form::file,
                "values from 0 (black) to 1 (white), in a PNG file over the mesh's texture coordinates",
                {.what = "the name of a PNG file", .excludes = {"vdb", "property"}}, read_texture),
    special_key("vdb", Form::file, "values of a float grid, in the frame and unit of the mesh file",
                {.what = "the name of an OpenVDB file", .excludes = {"property"}}, read_vdb),
    special_key("grid", Form::text, "the name of the grid in the file of `vdb`",
                {.what = "the name of a float grid", .otherwise = "the only float grid"}, read_grid),
    special_key("property", Form::text, "values that the mesh's PLY file has for each vertex",
                {.what = "the name of a property of vertices"}, read_property)};

/// Reports a map without a source. Returns the place of the key that gives the source, "FILE:LINE:
/// dotted.key".
std::string complete_map_source(TomlTable& map);

}  // namespace sherd
