// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/fracture.h"

#include <array>

namespace sherd {
namespace {

/// One number for all directions, or two: along and across the material's axis.
void read_value(TomlTable& table, std::string_view key, std::string_view unit, Strength& strength) {
    if (table.is_array(key)) {
        const Eigen::Vector2d both = table.pair(key, unit, positive);
        strength.along = both[0];
        strength.across = both[1];
    } else {
        strength.along = strength.across = table.number(key, unit, positive);
    }
}

Strength read_strength(TomlTable& table) {
    Strength strength;
    const bool in_pascal = table.has("strength");
    if (in_pascal && table.has("strain")) table.report("strength", "conflicts with strain: give one of them");
    if (!in_pascal && !table.has("strain"))
        table.report("", "needs strain (1/m) or strength (Pa): what the sheet withstands");
    if (in_pascal) {
        strength.measure = Measure::stress;
        read_value(table, "strength", "Pa", strength);
    } else if (table.has("strain")) {
        read_value(table, "strain", "1/m", strength);
    }
    if (table.has("measure")) {
        constexpr std::array<std::string_view, 2> names{"surface", "bending"};
        if (table.choice("measure", names) == "bending") {
            if (in_pascal)
                table.report("measure", "\"bending\" is a strain: give strain (1/m) instead of strength");
            strength.measure = Measure::bending;
        }
    }
    strength.crack_tip_factor =
        table.number("crack_tip", "", {[](double x) { return x > 0 && x <= 1; }, "a number above 0, up to 1"},
                     strength.crack_tip_factor);
    return strength;
}

/// Cracks that go on by toughness are born where the stress is over the strength, and have rules of their
/// own.
void read_toughness(TomlTable& table, FractureSpec& fracture) {
    const bool energy = table.has("fracture_energy");
    if (energy && table.has("toughness"))
        table.report("fracture_energy", "conflicts with toughness: give one of them");
    if (!energy && !table.has("toughness")) {
        if (table.has("speed_limit")) table.report("speed_limit", "needs toughness, or fracture_energy");
        return;
    }
    if (energy)
        fracture.fracture_energy = table.number("fracture_energy", "J/m^2", positive);
    else
        fracture.toughness = table.number("toughness", "Pa m^0.5", positive);
    if (table.has("speed_limit")) fracture.speed_limit = table.number("speed_limit", "m/s", positive);
    const char* key = energy ? "fracture_energy" : "toughness";
    if (!table.has("strength"))
        table.report(key, "needs strength (Pa), over which cracks are born, instead of strain");
    if (table.has("crack_tip"))
        table.report("crack_tip", "conflicts with toughness, by which the tips of cracks go on");
    if (fracture.strength.along != fracture.strength.across)
        table.report(key, "is for one strength in all directions yet");
}

StrengthMap read_map(TomlTable& table, const std::filesystem::path& directory) {
    StrengthMap map;
    const bool texture = table.has("texture"), vdb = table.has("vdb");
    if (texture == vdb) table.report("", "needs one of texture and vdb");
    map.where = table.where(texture ? "texture" : "vdb");
    if (texture) map.kind = StrengthTexture{directory / table.string("texture", "the name of a PNG file")};
    if (vdb) {
        StrengthGrid grid{directory / table.string("vdb", "the name of an OpenVDB file")};
        if (table.has("grid")) grid.name = table.string("grid", "the name of a float grid");
        map.kind = grid;
    }
    if (table.has("range")) map.range = table.pair("range", "", not_negative, false);
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

Score read_score(TomlTable& table, const std::filesystem::path& directory) {
    Score score = read_edges(table, directory);
    score.factor = table.number("factor", "", positive);
    table.finish();
    return score;
}

}  // namespace

FractureSpec read_fracture(TomlTable& table, const std::filesystem::path& directory) {
    FractureSpec fracture;
    fracture.strength = read_strength(table);
    read_toughness(table, fracture);
    if (table.has("weibull")) fracture.weibull_modulus = table.number("weibull", "", positive);
    if (table.has("weibull_area")) {
        if (!table.has("weibull")) table.report("weibull_area", "needs weibull, the modulus of the scatter");
        fracture.weibull_area = table.number("weibull_area", "m^2", positive);
    }
    if (auto map = table.table("map")) fracture.map = read_map(*map, directory);
    for (TomlTable& score : table.tables("score")) fracture.scores.push_back(read_score(score, directory));
    for (TomlTable& crack : table.tables("crack")) {
        fracture.cracks.push_back(read_edges(crack, directory));
        crack.finish();
    }
    table.finish();
    return fracture;
}

}  // namespace sherd
