// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_fracture.h"

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

}  // namespace

FractureSpec read_fracture(TomlTable& table) {
    FractureSpec fracture;
    fracture.strength = read_strength(table);
    if (table.has("weibull")) fracture.weibull_modulus = table.number("weibull", "", positive);
    if (table.has("weibull_area")) {
        if (!table.has("weibull")) table.report("weibull_area", "needs weibull, the modulus of the scatter");
        fracture.weibull_area = table.number("weibull_area", "m^2", positive);
    }
    table.finish();
    return fracture;
}

}  // namespace sherd
