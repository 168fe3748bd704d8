// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/map_source.h"

namespace sherd {

MapSource read_map_source(TomlTable& map, const std::filesystem::path& directory, std::string& where) {
    const bool texture = map.has("texture"), vdb = map.has("vdb"), property = map.has("property");
    if (texture + vdb + property != 1) map.report("", "needs one of texture, vdb and property");
    where = map.where(texture ? "texture" : vdb ? "vdb" : "property");
    MapSource source;
    if (texture) source = MapTexture{directory / map.string("texture", "the name of a PNG file")};
    if (vdb) {
        MapGrid grid{directory / map.string("vdb", "the name of an OpenVDB file")};
        if (map.has("grid")) grid.name = map.string("grid", "the name of a float grid");
        source = grid;
    }
    if (property) source = MapProperty{map.string("property", "the name of a property of vertices")};
    return source;
}

}  // namespace sherd
