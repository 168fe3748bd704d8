// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material.h"

#include <cmath>

namespace sherd {

double bending_rigidity(const Material& material) {
    return material.young * std::pow(material.thickness, 3) /
           (12 * (1 - material.poisson * material.poisson));
}

double hinge_stiffness(const Material& material) {
    return bending_rigidity(material) / 3;
}

Matrix3d membrane_elasticity(const Material& material) {
    const double nu = material.poisson;
    Matrix3d c;
    c << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
    return material.young * material.thickness / (1 - nu * nu) * c;
}

}  // namespace sherd
