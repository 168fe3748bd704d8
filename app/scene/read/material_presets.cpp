// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/material_presets.h"

#include <array>

namespace sherd {

std::span<const MaterialPreset> material_presets() {
    // density, thickness, young, poisson
    static constexpr std::array<MaterialPreset, 7> presets{{
        {"stoneware", {2400, 0.004, 7e10, 0.2}},
        {"porcelain", {2400, 0.003, 7e10, 0.2}},
        {"glass", {2500, 0.004, 7e10, 0.2}},
        {"steel", {7850, 0.001, 2.1e11, 0.3}},
        {"aluminium", {2700, 0.001, 7e10, 0.3}},
        {"paper", {780, 0.0001, 3e9, 0.2}},
        {"cotton", {500, 0.0003, 2e6, 0.2}},
    }};
    return presets;
}

}  // namespace sherd
