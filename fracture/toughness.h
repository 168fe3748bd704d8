// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/material/material.h"

namespace sherd {

/// Where cracks run.
enum class CrackPath {
    cut,   ///< where they want to: the mesh is made to have an edge there (advance_edge())
    edges  ///< along edges of the mesh as it is
};

/// What decides where the cracks of a sheet go on.
struct Toughness {
    /// K_Ic, Pa m^0.5, of a crack that is pulled along the first material axis; 0: none, hinges go by their
    /// strength alone.
    double value = 0;
    double speed_limit = 0;  ///< m/s, that no tip exceeds
    CrackPath path = CrackPath::cut;
    std::optional<double> across = {};  ///< the same for a pull across it; none: as along it
    std::vector<double> factors = {};   ///< [E] factor on the toughness of each edge; empty: 1

    bool given() const { return value > 0; }
    bool has_directions() const { return across && *across != value; }
};

/// Toughness of an edge that makes `angle` (rad) with the first material axis, without its factor: between
/// the axes by hankinson(), as strength.
double directional_toughness(const Toughness& toughness, double angle);

/// K_Ic, Pa m^0.5, of the energy (J/m^2) that a metre of crack takes for each metre of thickness, in plane
/// stress: sqrt(Y G_c).
double toughness_of_energy(double energy, const Material& material);

/// The speed that cracks in brittle materials do not exceed, m/s: 0.45 of that of shear waves. In glass this
/// is 1,500 (Schardin 1959: 1,520), in PMMA 450, above the 330 from which on its cracks sprout micro-branches
/// (Fineberg, Gross, Marder and Swinney 1992; Sharon, Gross and Fineberg 1995).
double usual_speed_limit(const Material& material);

}  // namespace sherd
