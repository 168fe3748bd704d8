// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet/material_presets.h"

#include <algorithm>

namespace sherd {
namespace {

/// Returns fracture data that are equal in all directions.
constexpr FracturePreset brittle(double strength, double weibull_modulus, double weibull_area,
                                 double toughness, double speed_limit = 0) {
    return {strength, strength, weibull_modulus, weibull_area, toughness, toughness, speed_limit};
}

constexpr Material metal(double density, double young, double yield) {
    return {.density = density, .thickness = 0.001, .young = young, .poisson = 0.3, .yield = yield};
}

// Birch plywood of five plies; the fibres of the outer plies run along the axis.
constexpr Material plywood{680, 0.0065, 1.27e10, 0.1, 4.8e9, 6.2e8};
constexpr FracturePreset broken_plywood{6.2e7, 3.6e7, 12, 0.09, 3.9e6, 2.8e6};

// density, thickness, young, poisson; strength, Weibull modulus and area, toughness, speed limit
constexpr std::array<MaterialPreset, preset_names.size()> presets{{
    {"stoneware", {2400, 0.004, 7e10, 0.2}, brittle(4e7, 10, 1e-3, 1.2e6)},
    {"porcelain", {2400, 0.003, 7e10, 0.2}, brittle(6e7, 10, 1e-3, 1.2e6)},
    {"glass", {2500, 0.004, 7e10, 0.2}, brittle(6.5e7, 7, 0.07, 7.5e5, 1500)},
    {"pmma", {1190, 0.003, 3.2e9, 0.35}, brittle(7.2e7, 15, 1e-3, 1.1e6, 400)},
    {"eggshell", {2300, 0.00035, 3e10, 0.3}, brittle(2e7, 8, 5e-3, 3e5)},
    {"plaster", {1100, 0.01, 4.5e9, 0.2}, brittle(4e6, 10, 1e-3, 1.4e5)},
    {"plywood", plywood, broken_plywood},
    {"steel", metal(7850, 2.1e11, 2.35e8)},
    {"aluminium", metal(2700, 7e10, 2.6e8)},
    {"paper", {780, 0.0001, 3e9, 0.2}},
    {"cotton", {500, 0.0003, 2e6, 0.2}},
}};
static_assert(!presets.back().name.empty(), "preset_names has room for more presets than there are");

constexpr auto names_of_presets() {
    std::array<std::string_view, presets.size()> names;
    std::ranges::transform(presets, names.begin(), &MaterialPreset::name);
    return names;
}

}  // namespace

constinit const std::array<std::string_view, presets.size()> preset_names = names_of_presets();

std::span<const MaterialPreset> material_presets() {
    return presets;
}

}  // namespace sherd
