// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/strength.h"

#include "app/scene/build/score.h"
#include "app/scene/build/strength_map.h"

namespace sherd {
namespace {

/// Other numbers for each sheet, and others than those that the meshes are generated from.
std::uint32_t scatter_seed(const SheetSpec& sheet, const Scene& scene) {
    const auto number = static_cast<std::uint32_t>(&sheet - scene.sheets.data());
    constexpr std::uint32_t odd = 0x9E3779B9;
    return static_cast<std::uint32_t>(scene.seed) + odd * (number + 1);
}

/// From the placed mesh back to the frame of its file.
Eigen::Affine3d to_file(const SheetSpec& sheet) {
    const auto* file = std::get_if<MeshFile>(&sheet.mesh);
    return Eigen::Scaling(1 / (file ? file->scale : 1)) * Eigen::Affine3d(sheet.place.inverse());
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
    if (fracture.map || !fracture.scores.empty()) strength.factors.resize(placed.number_of_edges(), 1);
    if (fracture.map) {
        const std::vector<double> map = map_factors(*fracture.map, placed, to_file(sheet), warnings);
        for (std::size_t e = 0; e < map.size(); ++e) strength.factors[e] *= map[e];
    }
    for (const Score& score : fracture.scores)
        for (const Edge edge : scored_edges(score, placed, sheet.place))
            strength.factors[edge] *= score.factor;
    return strength;
}

Toughness sheet_toughness(const FractureSpec& fracture, const Material& material) {
    Toughness toughness;
    toughness.value = fracture.fracture_energy > 0 ? toughness_of_energy(fracture.fracture_energy, material)
                                                   : fracture.toughness;
    toughness.speed_limit = fracture.speed_limit > 0 ? fracture.speed_limit : usual_speed_limit(material);
    return toughness;
}

}  // namespace sherd
