// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/fracture.h"

#include <fmt/ranges.h>

#include <array>

#include "app/scene/read/map_source.h"

namespace sherd {
namespace {

/// One number for all directions, or two: along and across the material's axis.
Eigen::Vector2d read_value(TomlTable& table, std::string_view key, std::string_view unit) {
    if (table.is_array(key)) return table.pair(key, unit, positive);
    return Eigen::Vector2d::Constant(table.number(key, unit, positive));
}

/// How the sheet's material breaks, if the scene wants it to; null: the scene tells it.
const FracturePreset* read_fracture_preset(TomlTable& table, const MaterialPreset* material) {
    if (!table.flag("preset", false)) return nullptr;
    if (material && material->fracture) return &*material->fracture;
    std::vector<std::string_view> names;
    for (const MaterialPreset& known : material_presets())
        if (known.fracture) names.push_back(known.name);
    table.report("preset", fmt::format("needs one of these as material.preset: {}", fmt::join(names, ", ")));
    static constexpr FracturePreset none{};  // which is one mistake, not two
    return &none;
}

/// What a hinge fails by, in the unit of the key that gives its strength.
Measure read_measure(TomlTable& table, bool in_pascal) {
    constexpr std::array<std::string_view, 2> names{"surface", "bending"};
    if (!table.has("measure") || table.choice("measure", names) != "bending")
        return in_pascal ? Measure::stress : Measure::strain;
    if (in_pascal) table.report("measure", "\"bending\" is a strain: give strain (1/m) instead of strength");
    return Measure::bending;
}

Strength read_strength(TomlTable& table, const FracturePreset* preset) {
    const bool given = table.has("strength"), in_pascal = given || preset, in_strain = table.has("strain");
    if (in_pascal && in_strain)
        table.report(given ? "strength" : "preset", "conflicts with strain: give one of them");
    if (!in_pascal && !in_strain)
        table.report("", "needs strain (1/m) or strength (Pa): what the sheet withstands; or preset = true");
    Strength strength;
    strength.measure = read_measure(table, in_pascal);
    Eigen::Vector2d value(strength.along, strength.across);
    if (given)
        value = read_value(table, "strength", "Pa");
    else if (preset)
        value = {preset->strength, preset->strength_across};
    else if (in_strain)
        value = read_value(table, "strain", "1/m");
    strength.along = value[0];
    strength.across = value[1];
    strength.crack_tip_factor =
        table.number("crack_tip", "", {[](double x) { return x > 0 && x <= 1; }, "a number above 0, up to 1"},
                     strength.crack_tip_factor);
    return strength;
}

/// Reads the toughness and returns the key that gives it; empty: there is none.
std::string_view read_toughness_value(TomlTable& table, const FracturePreset* preset,
                                      FractureSpec& fracture) {
    const bool energy = table.has("fracture_energy"), intensity = table.has("toughness");
    if (energy && intensity) table.report("fracture_energy", "conflicts with toughness: give one of them");
    if (energy) {
        fracture.fracture_energy = table.number("fracture_energy", "J/m^2", positive);
        return "fracture_energy";
    }
    if (!intensity && !preset) return "";
    const Eigen::Vector2d value = intensity ? read_value(table, "toughness", "Pa m^0.5")
                                            : Eigen::Vector2d(preset->toughness, preset->toughness_across);
    fracture.toughness = value[0];
    if (value[1] != value[0]) fracture.toughness_across = value[1];
    return intensity ? "toughness" : "preset";
}

/// Cracks that go on by toughness are born where the stress is over the strength, and have rules of their
/// own.
void read_toughness(TomlTable& table, const FracturePreset* preset, FractureSpec& fracture) {
    const std::string_view key = read_toughness_value(table, preset, fracture);
    if (preset) fracture.speed_limit = preset->speed_limit;
    if (table.has("speed_limit")) {
        fracture.speed_limit = table.number("speed_limit", "m/s", positive);
        if (key.empty()) table.report("speed_limit", "needs toughness, or fracture_energy");
    }
    if (table.has("path")) {
        constexpr std::array<std::string_view, 2> paths{"cut", "edges"};
        fracture.path = table.choice("path", paths) == "edges" ? CrackPath::edges : CrackPath::cut;
        if (key.empty()) table.report("path", "needs toughness, or fracture_energy");
    }
    if (key.empty()) return;
    if (!table.has("strength") && !preset)
        table.report(key, "needs strength (Pa), over which cracks are born, instead of strain");
    if (table.has("crack_tip"))
        table.report("crack_tip", "conflicts with toughness, by which the tips of cracks go on");
}

void read_scatter(TomlTable& table, const FracturePreset* preset, FractureSpec& fracture) {
    if (preset) {
        fracture.weibull_modulus = preset->weibull_modulus;
        fracture.weibull_area = preset->weibull_area;
    }
    if (table.has("weibull")) fracture.weibull_modulus = table.number("weibull", "", positive);
    if (table.has("weibull_area")) {
        if (!table.has("weibull") && !preset)
            table.report("weibull_area", "needs weibull, the modulus of the scatter");
        fracture.weibull_area = table.number("weibull_area", "m^2", positive);
    }
}

/// What a map or a score multiplies.
FractureLaw read_law(TomlTable& table, bool has_toughness) {
    constexpr std::array<std::string_view, 2> names{"strength", "toughness"};
    if (!table.has("of") || table.choice("of", names) != "toughness") return FractureLaw::strength;
    if (!has_toughness) table.report("of", "\"toughness\" needs fracture.toughness, or fracture_energy");
    return FractureLaw::toughness;
}

StrengthMap read_map(TomlTable& table, const std::filesystem::path& directory, bool has_toughness) {
    StrengthMap map;
    map.source = read_map_source(table, directory, map.where);
    if (table.has("range")) map.range = table.pair("range", "", not_negative, false);
    map.of = read_law(table, has_toughness);
    if (table.has("value")) {
        constexpr std::array<std::string_view, 1> names{"never"};
        map.never = !table.choice("value", names).empty();
        for (const char* other : {"range", "of"})
            if (table.has(other))
                table.report(other, "conflicts with value = \"never\", which keeps what is white whole");
    }
    table.finish();
    return map;
}

/// Which edges: one of `edges` and `line`.
Score read_edges(TomlTable& table, const std::filesystem::path& directory) {
    Score score;
    const bool edges = table.has("edges"), line = table.has("line");
    if (edges && line) table.report("line", "conflicts with edges: give one of them");
    if (!edges && !line) table.report("", "needs one of edges and line");
    score.where = table.where(edges ? "edges" : "line");
    if (edges) score.kind = ScoreFile{directory / table.string("edges", "the name of a list of edges")};
    if (line) {
        ScoreLine polyline;
        for (const Eigen::VectorXd& point : table.rows("line", "m", 2, 3)) polyline.points.push_back(point);
        score.kind = polyline;
    }
    return score;
}

Score read_score(TomlTable& table, const std::filesystem::path& directory, bool has_toughness) {
    Score score = read_edges(table, directory);
    score.factor = table.number("factor", "", positive);
    score.of = read_law(table, has_toughness);
    table.finish();
    return score;
}

}  // namespace

FractureSpec read_fracture(TomlTable& table, const std::filesystem::path& directory,
                           const MaterialPreset* material) {
    FractureSpec fracture;
    const FracturePreset* preset = read_fracture_preset(table, material);
    fracture.strength = read_strength(table, preset);
    read_toughness(table, preset, fracture);
    read_scatter(table, preset, fracture);
    const bool tough = fracture.has_toughness();
    for (TomlTable& map : table.tables("map")) fracture.maps.push_back(read_map(map, directory, tough));
    for (TomlTable& score : table.tables("score"))
        fracture.scores.push_back(read_score(score, directory, tough));
    for (TomlTable& crack : table.tables("crack")) {
        fracture.cracks.push_back(read_edges(crack, directory));
        crack.finish();
    }
    fracture.art_direction.after = table.number("after", "s", not_negative, 0.0);
    if (table.has("smallest")) fracture.art_direction.smallest = table.number("smallest", "m", positive);
    table.finish();
    return fracture;
}

}  // namespace sherd
