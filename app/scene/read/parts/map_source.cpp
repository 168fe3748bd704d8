// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/map_source.h"

namespace sherd {

void read_texture(TomlTable& table, const KeyInfo& key, MapSource& source) {
    if (table.has(key.name)) source = MapTexture{table.file(key.name, key.rules.what)};
}

void read_vdb(TomlTable& table, const KeyInfo& key, MapSource& source) {
    if (table.has(key.name)) source = MapGrid{table.file(key.name, key.rules.what)};
}

void read_grid(TomlTable& table, const KeyInfo& key, MapSource& source) {
    if (!table.has(key.name)) return;
    if (auto* grid = std::get_if<MapGrid>(&source))
        grid->name = table.string(key.name, key.rules.what);
    else
        table.report(key.name, "needs vdb, the file that has the grid");
}

void read_property(TomlTable& table, const KeyInfo& key, MapSource& source) {
    if (table.has(key.name)) source = MapProperty{table.string(key.name, key.rules.what)};
}

std::string complete_map_source(TomlTable& map) {
    const bool texture = map.has("texture"), vdb = map.has("vdb"), property = map.has("property");
    if (!texture && !vdb && !property) map.report("", "needs one of texture, vdb and property");
    return map.where(texture ? "texture" : vdb ? "vdb" : "property");
}

}  // namespace sherd
