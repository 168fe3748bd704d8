// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/winds.h"

#include <fmt/format.h>

#include "app/scene/read/sheet_name.h"

namespace sherd {
namespace {

GustSpec read_gust(TomlTable& table) {
    GustSpec gust;
    gust.amplitude = table.number("amplitude", "m/s", not_negative);
    gust.time = table.number("time", "s", positive);
    gust.length = table.number("length", "m", positive);
    table.finish();
    return gust;
}

WindSpec read_wind(TomlTable& table, const Scene& scene) {
    WindSpec spec;
    spec.where = table.where("");
    Wind& wind = spec.wind;
    wind.velocity = table.vector("velocity", "m/s", wind.velocity);
    wind.ramp = table.number("ramp", "s", not_negative, wind.ramp);
    wind.density = table.number("density", "kg/m^3", positive, wind.density);
    wind.drag = table.number("drag", "", not_negative, wind.drag);
    wind.lift = table.number("lift", "", not_negative, wind.lift);
    wind.friction = table.number("friction", "", not_negative, wind.friction);
    if (auto gust = table.table("gust")) spec.gust = read_gust(*gust);
    spec.sheet = read_sheet_name(table, scene);
    for (const WindSpec& other : scene.winds)
        if (other.sheet == spec.sheet || other.sheet.empty() || spec.sheet.empty())
            table.report("sheet", fmt::format("a sheet is in the wind of {} already: give each wind the name "
                                              "of another sheet",
                                              other.where));
    table.finish();
    return spec;
}

}  // namespace

void read_winds(TomlTable& force, Scene& scene) {
    for (TomlTable& wind : force.tables("wind")) scene.winds.push_back(read_wind(wind, scene));
}

}  // namespace sherd
