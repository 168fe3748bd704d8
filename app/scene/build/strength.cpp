// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/strength.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/scene/build/score.h"
#include "app/scene/build/strength_map.h"

namespace sherd {
namespace {

/// Least factor on the toughness: a toughness of 0 stands for none, with cracks by strength.
constexpr double least_factor = 1e-6;

/// Seed of the scatter, which differs for each sheet, and from the seed of generated meshes.
std::uint32_t scatter_seed(const SheetSpec& sheet, const Scene& scene) {
    const auto number = static_cast<std::uint32_t>(&sheet - scene.sheets.data());
    constexpr std::uint32_t odd = 0x9E3779B9;
    return static_cast<std::uint32_t>(scene.seed) + odd * (number + 1);
}

/// Multiplies the factors of edges [E] by those of the maps and the scores of one law.
void add_maps(const SheetSpec& sheet, FractureLaw law, const Mesh& placed, std::vector<double>& factors,
              std::vector<std::string>& warnings) {
    const auto factor_of = [&](Edge edge) -> double& {
        factors.resize(placed.number_of_edges(), 1);
        return factors[edge];
    };
    for (const StrengthMap& map : sheet.fracture->maps) {
        if (map.of != law) continue;
        const std::vector<double> values = map_factors(map, sheet, placed, warnings);
        for (const Edge edge : placed.edges()) {
            double& factor = factor_of(edge);
            const bool never = std::isinf(factor) || std::isinf(values[edge]);  // also times zero
            factor = never ? std::numeric_limits<double>::infinity() : factor * values[edge];
        }
    }
    for (const Score& score : sheet.fracture->scores)
        if (score.of == law)
            for (const Edge edge : scored_edges(score, placed, sheet.place)) factor_of(edge) *= score.factor;
}

}  // namespace

Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed,
                        std::vector<std::string>& warnings) {
    const FractureSpec& fracture = *sheet.fracture;
    Strength strength = fracture.strength;
    if (fracture.weibull_modulus > 0)
        strength.factors = weibull_factors(placed, {.modulus = fracture.weibull_modulus,
                                                    .area = fracture.weibull_area,
                                                    .seed = scatter_seed(sheet, scene)});
    add_maps(sheet, FractureLaw::strength, placed, strength.factors, warnings);
    return strength;
}

Toughness sheet_toughness(const SheetSpec& sheet, const Mesh& placed, std::vector<std::string>& warnings) {
    const FractureSpec& fracture = *sheet.fracture;
    Toughness toughness;
    toughness.value = fracture.fracture_energy > 0
                          ? toughness_of_energy(fracture.fracture_energy, sheet.material)
                          : fracture.toughness;
    toughness.across = fracture.toughness_across;
    toughness.path = fracture.path;
    toughness.speed_limit =
        fracture.speed_limit > 0 ? fracture.speed_limit : usual_speed_limit(sheet.material);
    add_maps(sheet, FractureLaw::toughness, placed, toughness.factors, warnings);
    for (double& factor : toughness.factors) factor = std::max(factor, least_factor);
    return toughness;
}

}  // namespace sherd
