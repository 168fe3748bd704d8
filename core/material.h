// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// A homogeneous isotropic sheet, SI units.
struct Material {
    double density = 0;    ///< kg/m^3
    double thickness = 0;  ///< m
    double young = 0;      ///< Pa
    double poisson = 0;
};

/// Plate rigidity D = Y t^3 / (12 (1 - nu^2)), N m.
double bending_rigidity(const Material& material);

/// lambda of every hinge, N m: a third of the rigidity, because a hinge mesh of stiffness lambda resists
/// developable bending like a plate of rigidity 3 lambda.
double hinge_stiffness(const Material& material);

/// Plane-stress elasticity times thickness, N/m, [3, 3] on the Green strain (E00, E11, 2 E01).
Matrix3d membrane_elasticity(const Material& material);

}  // namespace sherd
