// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/toughness.h"

#include <cmath>

#include "fracture/shell/strength.h"

namespace sherd {

double directional_toughness(const Toughness& toughness, double angle) {
    return hankinson(toughness.value, toughness.across.value_or(toughness.value), angle);
}

double toughness_of_energy(double energy, const Material& material) {
    return std::sqrt(energy * mean_young(material));
}

double usual_speed_limit(const Material& material) {
    return 0.45 * std::sqrt(elastic_constants(material).shear / material.density);
}

}  // namespace sherd
