// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/material/material.h"

namespace sherd {

/// Fracture data of a material, along and across its axis: for tension in that direction.
struct FracturePreset {
    double strength = 0, strength_across = 0;      ///< Pa, mean of a patch of weibull_area
    double weibull_modulus = 0, weibull_area = 0;  ///< m^2
    double toughness = 0, toughness_across = 0;    ///< Pa m^0.5
    double speed_limit = 0;                        ///< m/s; 0: by the material, usual_speed_limit()
};

/// A material by name, with the thickness of a common sheet of it.
struct MaterialPreset {
    std::string_view name;
    Material material;
    std::optional<FracturePreset> fracture = {};  ///< none: not brittle
};

/// Returns presets of real materials; docs/scene.md gives the source of each.
std::span<const MaterialPreset> material_presets();

}  // namespace sherd
