// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

void read_box(TomlTable& table, const KeyInfo& key, Selection& selection);

inline constexpr std::array selection_keys{
    special_key("box", Form::rows,
                "`[[x, y, z], [x, y, z]]`, lower and upper corner of a box: the placed vertices in it",
                {.unit = "m", .otherwise = "none", .least_rows = 2, .columns = 3, .most_rows = 2}, read_box),
    key<&Selection::boundary>("boundary", "`true`: all vertices of the boundary"),
    key<&Selection::group>(
        "group", "the vertices of the faces in this group of the mesh file",
        {.what = "the name of a group of the mesh file", .otherwise = "none", .excludes = {"box"}})};

/// Whether a table has a key of a selection: box, boundary or group.
bool selects(TomlTable& table);
/// Reports a table with none of the keys box, boundary and group, and one in which boundary conflicts with
/// another of them. Sets Selection::where.
void complete_selection(TomlTable& table, Selection& selection);

}  // namespace sherd
