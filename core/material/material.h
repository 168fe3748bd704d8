// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/material/orthotropy.h"

namespace sherd {

/// The stiffness of a hinge, as a share of the plate's rigidity.
enum class Calibration {
    third,  ///< a third: a mesh of hinges of stiffness lambda resists developable bending like a plate of
            ///< rigidity 3 lambda
    paper   ///< the whole rigidity, as in the paper
};

/// A homogeneous material, SI units: isotropic, or orthotropic along two perpendicular axes.
struct Material {
    double density = 0;    ///< kg/m^3
    double thickness = 0;  ///< m
    double young = 0;      ///< Pa, along the first material axis
    double poisson = 0;    ///< nu01: contraction along the second axis for a stretch along the first
    std::optional<double> young1 = {};  ///< Pa, along the second axis; none: as along the first
    std::optional<double> shear = {};   ///< G01, Pa; none: see elastic_constants()
    Calibration calibration = Calibration::third;
    double tempered = 0;  ///< Pa, compression at the surfaces of tempered sheets, balanced by tension inside
    /// Pa, von Mises stress beyond which sheets yield; simulated by coupled hinges only
    /// (ShellEnergyOptions::yields); 0: none.
    double yield = 0;
};

/// Whether all directions in the sheet are equivalent, so that the material axes do not matter.
bool is_isotropic(const Material& material);

/// The material's constants. If the shear modulus is not given, it is sqrt(Y0 Y1) / (2 (1 + nu)), where nu is
/// the geometric mean of nu01 and nu10 (Huber); for an isotropic sheet this is Y / (2 (1 + nu)).
Orthotropy elastic_constants(const Material& material);

/// Plate rigidity D = Y t^3 / (12 (1 - nu^2)), N m; for an orthotropic sheet the geometric mean of the
/// rigidities along its two axes.
double bending_rigidity(const Material& material);

/// Young's modulus, Pa; for an orthotropic sheet the geometric mean of its two moduli.
double mean_young(const Material& material);

/// Stiffness lambda, N m, of a hinge whose rest edge makes `angle` (rad) with the first material axis: see
/// edge_stiffness() and Calibration.
double hinge_stiffness(const Material& material, double angle = 0);

/// Plane-stress elasticity times thickness, N/m, [3, 3], acting on the Green strain (E00, E11, 2 E01) in some
/// frame. angle: rad, counterclockwise, from the frame's first axis to the first material axis.
Matrix3d membrane_elasticity(const Material& material, double angle = 0);

/// Ratio of stretching stiffness to the hinges' bending stiffness for elements of a length (m): Y t / (lambda
/// / length^2), with the smaller Y and the larger lambda of the two axes. The cubic hinge is valid from about
/// 100 on (paper, section 8).
double stretch_over_bend(const Material& material, double length);
inline constexpr double least_stretch_over_bend = 100;

}  // namespace sherd
