// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/material/material.h"

namespace sherd {

/// Fracture data of a material: for tension along its axis, and across it (`_across`).
struct FracturePreset {
    double strength = 0, strength_across = 0;      ///< Pa, mean strength of patches of the area weibull_area
    double weibull_modulus = 0, weibull_area = 0;  ///< modulus; reference area, m^2
    double toughness = 0, toughness_across = 0;    ///< Pa m^0.5
    double speed_limit = 0;                        ///< m/s, of crack tips; 0: usual_speed_limit()
};

/// A material by name, with the thickness of a common sheet of it.
struct MaterialPreset {
    std::string_view name;
    Material material;
    std::optional<FracturePreset> fracture = {};  ///< none: the material is not brittle
};

/// Returns presets of real materials; docs/scene.md gives the source of each.
std::span<const MaterialPreset> material_presets();

/// Names of the presets, in the order of material_presets().
extern const std::array<std::string_view, 11> preset_names;

}  // namespace sherd
