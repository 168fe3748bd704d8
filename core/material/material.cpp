// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/material.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sherd {

bool is_isotropic(const Material& material) {
    return material.young1.value_or(material.young) == material.young && !material.shear;
}

Orthotropy elastic_constants(const Material& material) {
    Orthotropy constants;
    constants.young0 = material.young;
    constants.young1 = material.young1.value_or(material.young);
    constants.young01 = material.poisson * constants.young1;
    const double mean_poisson = material.poisson * std::sqrt(constants.young1 / constants.young0);
    constants.shear = material.shear.value_or(mean_young(material) / (2 * (1 + mean_poisson)));
    return constants;
}

double mean_young(const Material& material) {
    return std::sqrt(material.young * material.young1.value_or(material.young));
}

double bending_rigidity(const Material& material) {
    const Orthotropy constants = elastic_constants(material);
    return std::sqrt(edge_stiffness(constants, material.thickness, 0) *
                     edge_stiffness(constants, material.thickness, std::numbers::pi / 2));
}

double hinge_stiffness(const Material& material, double angle) {
    const double stiffness = edge_stiffness(elastic_constants(material), material.thickness, angle);
    return material.calibration == Calibration::third ? stiffness / 3 : stiffness;
}

Matrix3d membrane_elasticity(const Material& material, double angle) {
    return turned_elasticity(plane_stress_elasticity(elastic_constants(material), material.thickness), angle);
}

double stretch_over_bend(const Material& material, double length) {
    const Orthotropy constants = elastic_constants(material);
    const double young = std::min(constants.young0, constants.young1);
    const double stiffness =
        std::max(hinge_stiffness(material, 0), hinge_stiffness(material, std::numbers::pi / 2));
    return young * material.thickness * length * length / stiffness;
}

}  // namespace sherd
