// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/toughness.h"

#include <cmath>

namespace sherd {

double toughness_of_energy(double energy, const Material& material) {
    return std::sqrt(energy * mean_young(material));
}

double usual_speed_limit(const Material& material) {
    return 0.45 * std::sqrt(elastic_constants(material).shear / material.density);
}

}  // namespace sherd
