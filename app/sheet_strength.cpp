// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sheet_strength.h"

namespace sherd {
namespace {

/// Other numbers for each sheet, and others than those that the meshes are generated from.
std::uint32_t scatter_seed(const SheetSpec& sheet, const Scene& scene) {
    const auto number = static_cast<std::uint32_t>(&sheet - scene.sheets.data());
    constexpr std::uint32_t odd = 0x9E3779B9;
    return static_cast<std::uint32_t>(scene.seed) + odd * (number + 1);
}

}  // namespace

Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed) {
    const FractureSpec& fracture = *sheet.fracture;
    Strength strength = fracture.strength;
    if (fracture.weibull_modulus > 0)
        strength.factors = weibull_factors(placed, {.modulus = fracture.weibull_modulus,
                                                    .area = fracture.weibull_area,
                                                    .seed = scatter_seed(sheet, scene)});
    return strength;
}

}  // namespace sherd
