// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_force.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/scene_support.h"
#include "app/scene/scene_wind.h"
#include "meshops/error.h"

namespace sherd {
namespace {

void read_amount(TomlTable& table, LoadSpec& load) {
    const std::vector<std::string> kinds{"point", "line", "area", "pressure"};
    for (const std::string& kind : kinds) {
        if (!table.has(kind)) continue;
        if (!load.kind.empty())
            table.report(kind, fmt::format("conflicts with {}: write a load for each", load.kind));
        load.kind = kind;
    }
    if (load.kind == "pressure")
        load.pressure = table.number("pressure", "Pa", any_number);
    else if (!load.kind.empty())
        load.force = table.vector(load.kind, load.kind == "point"  ? "N"
                                             : load.kind == "line" ? "N/m"
                                                                   : "N/m^2");
    else
        table.report("", "has no size: give point, line, area (a vector) or pressure (a number)");
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

std::vector<Index> numbers_of(const std::vector<char>& selected) {
    std::vector<Index> numbers;
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v)
        if (selected[v]) numbers.push_back(v);
    return numbers;
}

std::vector<Index> selected_triangles(const Sheet& mechanics, const std::vector<char>& selected) {
    std::vector<Index> triangles;
    for (Index t = 0; t < static_cast<Index>(mechanics.triangles.size()); ++t) {
        const std::array<Index, 3>& v = mechanics.triangles[t].vertices;
        if (selected[v[0]] && selected[v[1]] && selected[v[2]]) triangles.push_back(t);
    }
    return triangles;
}

}  // namespace

std::string read_sheet_name(TomlTable& table, const Scene& scene) {
    if (!table.has("sheet")) return {};
    std::string name = table.string("sheet", "the name of a sheet");
    const bool known = std::any_of(scene.sheets.begin(), scene.sheets.end(),
                                   [&](const SheetSpec& sheet) { return sheet.name == name; });
    if (!name.empty() && !known)
        table.report("sheet", fmt::format("names no sheet of this scene: there is no [sheet.{}]", name));
    return name;
}

void read_forces(TomlTable& table, Scene& scene) {
    scene.gravity = table.vector("gravity", "m/s^2", scene.gravity);
    for (TomlTable& load : table.tables("load")) scene.loads.push_back(read_load(load, scene));
    read_winds(table, scene);
    table.finish();
}

void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Sheet& mechanics,
               SimulationOptions& options) {
    for (const LoadSpec& spec : scene.loads) {
        const std::vector<char> selected = selected_vertices(spec.on, spec.sheet, scene, inputs);
        Load load;
        load.ramp = spec.ramp;
        if (spec.kind == "point")
            load.dead = point_forces(mechanics, numbers_of(selected), spec.force);
        else if (spec.kind == "line")
            load.dead = line_forces(mechanics, boundary_sides(mechanics, selected), spec.force);
        else if (spec.kind == "area")
            load.dead = area_forces(mechanics, selected_triangles(mechanics, selected), spec.force);
        else
            load.pressed = selected_triangles(mechanics, selected);
        load.pressure = spec.pressure;
        if (load.dead.empty() && load.pressed.empty())
            throw Error(fmt::format("{}: acts on nothing: {} must be in its box, boundary or group",
                                    spec.where,
                                    spec.kind == "point"  ? "a vertex"
                                    : spec.kind == "line" ? "both ends of an edge of the boundary"
                                                          : "all vertices of a face"));
        options.stepper.shell.loads.push_back(load);
    }
}

}  // namespace sherd
