// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet/fracture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/scene/read/parts/map_source.h"
#include "app/scene/read/sheet/material_presets.h"

namespace sherd {
namespace {

constexpr std::array<std::string_view, 2> laws{"strength", "toughness"}, measures{"surface", "bending"},
    paths{"cut", "edges"};
constexpr std::array<std::string_view, 1> map_values{"never"};

/// Reads one number for all directions, or two: along and across the material's axis.
Eigen::Vector2d read_directional(TomlTable& table, const KeyInfo& key) {
    if (table.is_array(key.name)) return table.pair(key.name, key.rules.unit, key.rules.range);
    return Eigen::Vector2d::Constant(table.number(key.name, key.rules.unit, key.rules.range));
}

void set_strength(FractureSpec& fracture, Measure measure, const Eigen::Vector2d& value) {
    fracture.strength.measure = measure;
    fracture.strength.along = value[0];
    fracture.strength.across = value[1];
}

void set_toughness(FractureSpec& fracture, const Eigen::Vector2d& value) {
    fracture.toughness = value[0];
    fracture.toughness_across.reset();
    if (value[1] != value[0]) fracture.toughness_across = value[1];
}

/// If the key is true, sets the fracture data of the material's preset; keys that are read later override
/// them.
void read_fracture_preset(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (!table.flag(key.name, false)) return;
    static constexpr FracturePreset none{};  // used for a missing preset, so that only its lack is reported
    const bool is_known = fracture.material != nullptr && fracture.material->fracture.has_value();
    const FracturePreset& preset = is_known ? *fracture.material->fracture : none;
    set_strength(fracture, Measure::stress, {preset.strength, preset.strength_across});
    set_toughness(fracture, {preset.toughness, preset.toughness_across});
    fracture.speed_limit = preset.speed_limit;
    fracture.weibull_modulus = preset.weibull_modulus;
    fracture.weibull_area = preset.weibull_area;
    fracture.has_preset = true;
    if (is_known) return;
    std::vector<std::string_view> names;
    for (const MaterialPreset& known : material_presets())
        if (known.fracture) names.push_back(known.name);
    table.report(key.name, fmt::format("needs one of these as material.preset: {}", fmt::join(names, ", ")));
}

void read_strain(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (table.has(key.name)) set_strength(fracture, Measure::strain, read_directional(table, key));
}

void read_strength(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (table.has(key.name)) set_strength(fracture, Measure::stress, read_directional(table, key));
}

void read_measure(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (!table.has(key.name) || table.choice(key.name, key.rules.choices) != "bending") return;
    if (fracture.strength.measure == Measure::stress)
        table.report(key.name, "\"bending\" is a strain: give strain (1/m) instead of strength");
    fracture.strength.measure = Measure::bending;
}

void read_toughness(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (table.has(key.name)) set_toughness(fracture, read_directional(table, key));
}

void read_fracture_energy(TomlTable& table, const KeyInfo& key, FractureSpec& fracture) {
    if (!table.has(key.name)) return;
    if (!table.has("toughness")) set_toughness(fracture, Eigen::Vector2d::Zero());
    fracture.fracture_energy = table.number(key.name, key.rules.unit, key.rules.range);
}

void read_never(TomlTable& table, const KeyInfo& key, StrengthMap& map) {
    if (table.has(key.name)) map.never = !table.choice(key.name, key.rules.choices).empty();
}

void complete_map(TomlTable& table, StrengthMap& map) {
    map.where = complete_map_source(table);
}

constexpr auto map_keys =
    joined(embedded<map_source_keys, &StrengthMap::source>(),
           std::array{key<&StrengthMap::range>(
                          "range", "`[a, b]`: the factor is `a` where the value is 0 and `b` where it is 1",
                          {.range = not_negative, .otherwise = "the value itself", .excludes = {"value"}}),
                      special_key("value", Form::choice,
                                  "nothing breaks where the value is 0.5 or more; elsewhere nothing changes",
                                  {.choices = map_values, .otherwise = "the value is a factor"}, read_never),
                      key<&StrengthMap::of>("of", "property that is multiplied",
                                            {.choices = laws, .excludes = {"value"}})});
constexpr Section<StrengthMap> map_section{"A map of strength or toughness", map_keys, complete_map};

void read_edges(TomlTable& table, const KeyInfo& key, Score& score) {
    if (table.has(key.name)) score.kind = ScoreFile{table.file(key.name, key.rules.what)};
}

void read_line(TomlTable& table, const KeyInfo& key, Score& score) {
    if (!table.has(key.name)) return;
    ScoreLine line;
    for (const Eigen::VectorXd& point :
         table.rows(key.name, key.rules.unit, key.rules.least_rows, key.rules.columns))
        line.points.push_back(point);
    score.kind = line;
}

void complete_edges(TomlTable& table, Score& score) {
    const bool edges = table.has("edges");
    if (!edges && !table.has("line")) table.report("", "needs one of edges and line");
    score.where = table.where(edges ? "edges" : "line");
}

constexpr std::array edge_keys{
    special_key("edges", Form::file, "a list of edges of this mesh file, as for `sherd cut`",
                {.what = "the name of a list of edges"}, read_edges),
    special_key("line", Form::rows,
                "`[[x, y, z], [x, y, z], ...]`, a polyline in the mesh's frame, before `place`",
                {.unit = "m", .excludes = {"edges"}, .least_rows = 2, .columns = 3}, read_line)};
constexpr auto score_keys = joined(
    edge_keys,
    std::array{
        key<&Score::factor>("factor", "factor of the strength, or of the toughness",
                            {.range = positive, .required = true}),
        key<&Score::of>("of", "property that is multiplied; with `\"toughness\"` the line guides cracks",
                        {.choices = laws})});
constexpr Section<Score> score_section{"A scored line", score_keys, complete_edges};
constexpr Section<Score> crack_section{"An initial crack", edge_keys, complete_edges};

void check_strength(TomlTable& table, const FractureSpec& fracture) {
    const bool given = table.has("strength"), in_strain = table.has("strain");
    if (in_strain && (given || fracture.has_preset))
        table.report(given ? "strength" : "preset", "conflicts with strain: give one of them");
    if (!in_strain && !given && !fracture.has_preset)
        table.report("",
                     "needs strain (1/m) or strength (Pa), above which the sheet breaks; or preset = true");
}

/// Checks the keys of the toughness. A toughness needs a strength (Pa), and conflicts with crack_tip.
void check_toughness(TomlTable& table, const FractureSpec& fracture) {
    const char* given = table.has("fracture_energy") ? "fracture_energy"
                        : table.has("toughness")     ? "toughness"
                                                     : nullptr;
    if (given == nullptr && !fracture.has_preset) {
        for (const char* key : {"speed_limit", "path"})
            if (table.has(key)) table.report(key, "needs toughness, or fracture_energy");
        return;
    }
    if (!table.has("strength") && !fracture.has_preset)
        table.report(given, "needs strength (Pa), above which cracks start, instead of strain");
    if (table.has("crack_tip"))
        table.report("crack_tip", "conflicts with toughness, which decides when crack tips propagate");
}

/// Reports maps and scores of the toughness if the sheet has no toughness.
void check_laws(TomlTable& table, const FractureSpec& fracture) {
    if (fracture.has_toughness()) return;
    const auto check = [](TomlTable& factor, FractureLaw law) {
        if (law == FractureLaw::toughness)
            factor.report("of", "\"toughness\" needs fracture.toughness, or fracture_energy");
    };
    std::vector<TomlTable> maps = table.tables("map"), scores = table.tables("score");
    for (std::size_t i = 0; i < maps.size(); ++i) check(maps[i], fracture.maps[i].of);
    for (std::size_t i = 0; i < scores.size(); ++i) check(scores[i], fracture.scores[i].of);
}

void complete_fracture(TomlTable& table, FractureSpec& fracture) {
    check_strength(table, fracture);
    check_toughness(table, fracture);
    if (table.has("weibull_area") && !table.has("weibull") && !fracture.has_preset)
        table.report("weibull_area", "needs weibull, the modulus of the scatter");
    check_laws(table, fracture);
}

constexpr Range above_0_to_1{.least = 0, .most = 1, .with_most = true};

constexpr std::array fracture_keys{
    special_key("preset", Form::flag,
                "`true`: takes the values of the material's preset; other keys override them",
                {.otherwise = "`false`"}, read_fracture_preset),
    special_key("strain", Form::number | Form::pair,
                "threshold of a hinge: times half the thickness, it is the tensile strain at the surface",
                {.unit = "1/m", .range = positive}, read_strain),
    special_key("strength", Form::number | Form::pair,
                "threshold of a hinge: the tensile stress at the surface", {.unit = "Pa", .range = positive},
                read_strength),
    special_key("measure", Form::choice,
                "`\"bending\"`, with `strain`: the hinge's bending strain alone is compared, as in the paper",
                {.choices = measures, .otherwise = "`\"surface\"`"}, read_measure),
    key<&FractureSpec::strength, &Strength::crack_tip_factor>(
        "crack_tip", "factor of the strength of a hinge that would continue a crack; 1: no difference",
        {.range = above_0_to_1}),
    special_key("toughness", Form::number | Form::pair,
                "K_Ic, above which cracks propagate; needs `strength`; `[along, across]`",
                {.unit = "Pa m^0.5", .range = positive, .otherwise = "none"}, read_toughness),
    special_key("fracture_energy", Form::number, "G_c, instead of `toughness`: K_Ic = sqrt(Y G_c)",
                {.unit = "J/m^2", .range = positive, .otherwise = "none", .excludes = {"toughness"}},
                read_fracture_energy),
    key<&FractureSpec::speed_limit>(
        "speed_limit", "largest speed of a crack tip",
        {.unit = "m/s", .range = positive, .otherwise = "0.45 of the material's shear wave speed"}),
    key<&FractureSpec::path>(
        "path", "whether cracks with a toughness cut the mesh along their path or follow its edges",
        {.choices = paths}),
    key<&FractureSpec::weibull_modulus>("weibull", "Weibull modulus of the scatter between hinges",
                                        {.range = positive, .otherwise = "no scatter"}),
    key<&FractureSpec::weibull_area>(
        "weibull_area", "area of sheet whose mean strength is the given one",
        {.unit = "m^2", .range = positive, .otherwise = "the area of each hinge"}),
    table_key<map_section, &FractureSpec::maps>(
        "map", "maps of strength or toughness, from a texture, an OpenVDB grid or a PLY file",
        {.otherwise = "uniform"}),
    table_key<score_section, &FractureSpec::scores>("score", "scored lines", {.otherwise = "none"}),
    table_key<crack_section, &FractureSpec::cracks>("crack", "initial cracks", {.otherwise = "none"}),
    key<&FractureSpec::art_direction, &ArtDirection::after>(
        "after", "time (in statics, load factor) before which nothing breaks, whatever the stress",
        {.unit = "s", .range = not_negative}),
    key<&FractureSpec::art_direction, &ArtDirection::smallest>(
        "smallest", "side of a square; smaller pieces do not come off; not with `rule = \"paper\"`",
        {.unit = "m", .range = positive, .otherwise = "any"})};
constexpr Section<FractureSpec> fracture_section{"Fracture", fracture_keys, complete_fracture};

}  // namespace

void read_fracture(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    auto inner = table.table(key.name);
    if (!inner) return;
    FractureSpec& fracture = sheet.fracture.emplace();
    fracture.material = sheet.preset;
    read_section(*inner, fracture_section, fracture);
}

std::vector<SectionText> inside_fracture() {
    return {text_of(fracture_section)};
}

}  // namespace sherd
