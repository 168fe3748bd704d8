// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/forces.h"

#include <fmt/format.h>

#include "app/scene/read/parts/selection.h"
#include "app/scene/read/parts/sheet_name.h"

namespace sherd {
namespace {

/// Sets the kind of a load to `key`, which gives the load's size; if the load has a kind already, reports the
/// key.
void take_kind(TomlTable& table, std::string_view key, LoadSpec& load) {
    if (!load.kind.empty())
        table.report(key, fmt::format("conflicts with {}: write a load for each", load.kind));
    load.kind = key;
}

void read_force(TomlTable& table, const KeyInfo& key, LoadSpec& load) {
    if (!table.has(key.name)) return;
    take_kind(table, key.name, load);
    load.force = table.vector(key.name, key.rules.unit);
}

template <double LoadSpec::*member>
void read_amount(TomlTable& table, const KeyInfo& key, LoadSpec& load) {
    if (!table.has(key.name)) return;
    take_kind(table, key.name, load);
    load.*member = table.number(key.name, key.rules.unit, key.rules.range);
}

void complete_load(TomlTable& table, LoadSpec& load) {
    load.where = table.where("");
    if (load.kind.empty())
        table.report("", "has no size: give point, line, area (a vector), pressure or moment (a number)");
    if (selects(table))
        complete_selection(table, load.on);
    else if (load.kind == "point")
        table.report("", "acts on no vertex: give box = [[...], [...]], boundary = true or group = \"NAME\"");
}

constexpr KeyRules some_sheet{.what = "the name of a sheet", .otherwise = "all"};

constexpr std::array size_keys{
    special_key("point", Form::vector, "force on each vertex of the selection, which it needs", {.unit = "N"},
                read_force),
    special_key(
        "line", Form::vector,
        "force per length at rest, on edges of the boundary with both ends in the selection; without a "
        "selection the load acts on the whole boundary",
        {.unit = "N/m"}, read_force),
    special_key(
        "area", Form::vector,
        "force per area at rest, on faces with all vertices in the selection; without a selection the "
        "load acts on the whole sheet; keeps its direction",
        {.unit = "N/m^2"}, read_force),
    special_key("pressure", Form::number,
                "pressure along the current normals of faces with all vertices in the selection; without a "
                "selection the load acts on the whole sheet",
                {.unit = "Pa"}, read_amount<&LoadSpec::pressure>),
    special_key("moment", Form::number, "moment per length at rest, on edges of the boundary, as for `line`",
                {.unit = "N m/m"}, read_amount<&LoadSpec::moment>)};
constexpr auto load_keys =
    joined(size_keys, embedded<selection_keys, &LoadSpec::on>(),
           std::array{key<&LoadSpec::sheet>("sheet", "name of the sheet that it acts on", some_sheet),
                      key<&LoadSpec::ramp>("ramp", "time in which the load grows linearly to its full size",
                                           {.unit = "s", .range = not_negative})});
constexpr Section<LoadSpec> load_section{"Loads", load_keys, complete_load};

constexpr std::array gust_keys{
    key<&GustSpec::amplitude>("amplitude", "root mean square of the gusts' magnitude",
                              {.unit = "m/s", .range = not_negative, .required = true}),
    key<&GustSpec::time>("time", "duration of a gust, in a frame that moves with the wind",
                         {.unit = "s", .range = positive, .required = true}),
    key<&GustSpec::length>("length", "size of a gust", {.unit = "m", .range = positive, .required = true})};
constexpr Section<GustSpec> gust_section{"Gusts", gust_keys};

void complete_wind(TomlTable& table, WindSpec& wind) {
    wind.where = table.where("");
}

constexpr std::array wind_keys{
    key<&WindSpec::wind, &Wind::velocity>("velocity", "velocity of the air", {.unit = "m/s"}),
    key<&WindSpec::wind, &Wind::ramp>("ramp",
                                      "time in which velocity and gusts grow linearly to their full size",
                                      {.unit = "s", .range = not_negative}),
    key<&WindSpec::wind, &Wind::density>("density",
                                         "density; the default is that of air at 15 °C, water has 1000",
                                         {.unit = "kg/m^3", .range = positive}),
    key<&WindSpec::wind, &Wind::drag>("drag", "drag coefficient of a face at right angles to the wind",
                                      {.range = not_negative}),
    key<&WindSpec::wind, &Wind::lift>(
        "lift", "slope of the normal force's coefficient over the angle of a face to the wind (1/rad)",
        {.range = not_negative}),
    key<&WindSpec::wind, &Wind::friction>("friction",
                                          "coefficient of the force along the face, for both sides together",
                                          {.range = not_negative}),
    table_key<gust_section, &WindSpec::gust>("gust", "gusts, added to `velocity`", {.otherwise = "none"}),
    key<&WindSpec::sheet>("sheet", "name of the sheet that it acts on; each sheet is in one wind only",
                          some_sheet)};
constexpr Section<WindSpec> wind_section{"Wind", wind_keys, complete_wind};

constexpr std::array force_keys{
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::gravity>(
        "gravity", "acceleration of gravity", {.unit = "m/s^2"}),
    table_key<load_section, &Scene::loads>("load", "loads on sheets", {.otherwise = "none"}),
    table_key<wind_section, &Scene::winds>("wind", "wind on sheets", {.otherwise = "none"})};

/// Reports names of sheets that the scene does not have, and sheets in two winds.
void complete_forces(TomlTable& table, Scene& scene) {
    for (TomlTable& load : table.tables("load")) check_sheet_name(load, scene);
    std::vector<TomlTable> winds = table.tables("wind");
    for (std::size_t i = 0; i < winds.size(); ++i) {
        check_sheet_name(winds[i], scene);
        for (std::size_t other = 0; other < i; ++other)
            if (scene.winds[i].sheet == scene.winds[other].sheet || scene.winds[i].sheet.empty() ||
                scene.winds[other].sheet.empty())
                winds[i].report(
                    "sheet",
                    fmt::format("a sheet is in the wind of {} already: name another sheet in each wind",
                                scene.winds[other].where));
    }
}

}  // namespace

constinit const Section<Scene> force_section{"Gravity, loads and wind", force_keys, complete_forces};

}  // namespace sherd
