// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

// Fields of an isotropic sheet near the tip of a straight crack that lies on the negative first axis, in the
// plane of the sheet. Angles are counted from the first axis to the second; a positive factor of the second
// mode shears the half with positive second coordinate forward, and turns the crack clockwise.

/// Young's modulus, Pa, and Poisson's ratio.
struct PlaneStress {
    double young = 0, poisson = 0;
};

/// Stress intensity factors of the opening mode (first) and of shear (second), Pa m^0.5.
struct ModePair {
    double first = 0, second = 0;
};

/// The membrane, in plane stress.
struct MembraneField {
    Vector3d stress;          ///< Pa, (00, 11, 01)
    Vector3d strain;          ///< (00, 11, 2 * 01)
    Vector2d along_gradient;  ///< derivative of the displacement along the first axis
};

/// Near-tip field of the membrane (Williams, On the stress distribution at the base of a stationary crack,
/// 1957). factors: K_I and K_II; the stresses 11 and 01 ahead of the crack are K_I / sqrt(2 pi r) and K_II /
/// sqrt(2 pi r). at: position, m, not zero.
MembraneField membrane_field(const PlaneStress& material, const ModePair& factors, const Vector2d& at);

/// Bending of the plate, without transverse shear (Kirchhoff).
struct PlateField {
    Vector3d curvature;  ///< 1/m, (00, 11, 2 * 01)
    double along_slope;  ///< derivative of the deflection along the first axis
};

/// Near-tip field of the plate (Williams, The bending stress distribution at the base of a stationary crack,
/// 1961; factors as in Hui and Zehnder, A theory for the fracture of thin plates subjected to bending and
/// twisting moments, 1993). factors: k_1 and k_2; at the surface that a positive curvature stretches, the
/// bending stress 11 ahead of the crack is k_1 / sqrt(2 r). thickness: m; at: position, m, not zero.
PlateField plate_field(const PlaneStress& material, double thickness, const ModePair& factors,
                       const Vector2d& at);

/// Release rate of the membrane in straight propagation, J/m^2.
double membrane_release(const PlaneStress& material, const ModePair& factors);
/// Release rate of bending in straight propagation, J/m^2: pi (1 + nu) / (3 Y (3 + nu)) (k_1^2 + k_2^2) (Hui
/// and Zehnder).
double plate_release(const PlaneStress& material, const ModePair& factors);

}  // namespace sherd
