// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/forces.h"

#include <fmt/format.h>

#include "app/scene/read/selection.h"
#include "app/scene/read/sheet_name.h"
#include "app/scene/read/winds.h"

namespace sherd {
namespace {

void read_amount(TomlTable& table, LoadSpec& load) {
    const std::vector<std::string> kinds{"point", "line", "area", "pressure", "moment"};
    for (const std::string& kind : kinds) {
        if (!table.has(kind)) continue;
        if (!load.kind.empty())
            table.report(kind, fmt::format("conflicts with {}: write a load for each", load.kind));
        load.kind = kind;
    }
    if (load.kind == "pressure")
        load.pressure = table.number("pressure", "Pa", any_number);
    else if (load.kind == "moment")
        load.moment = table.number("moment", "N m/m", any_number);
    else if (!load.kind.empty())
        load.force = table.vector(load.kind, load.kind == "point"  ? "N"
                                             : load.kind == "line" ? "N/m"
                                                                   : "N/m^2");
    else
        table.report("", "has no size: give point, line, area (a vector), pressure or moment (a number)");
}

LoadSpec read_load(TomlTable& table, const Scene& scene) {
    LoadSpec load;
    load.where = table.where("");
    read_amount(table, load);
    load.sheet = read_sheet_name(table, scene);
    if (table.has("box") || table.has("boundary") || table.has("group")) {
        load.on = read_selection(table);
    } else if (load.kind == "point") {
        table.report("", "acts on no vertex: give box = [[...], [...]], boundary = true or group = \"NAME\"");
    }
    load.ramp = table.number("ramp", "s", not_negative, 0);
    table.finish();
    return load;
}

}  // namespace

void read_forces(TomlTable& table, Scene& scene) {
    scene.gravity = table.vector("gravity", "m/s^2", scene.gravity);
    for (TomlTable& load : table.tables("load")) scene.loads.push_back(read_load(load, scene));
    read_winds(table, scene);
    table.finish();
}

}  // namespace sherd
