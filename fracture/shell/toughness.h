// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/material/material.h"

namespace sherd {

/// The path of cracks through the mesh.
enum class CrackPath {
    cut,   ///< along the computed direction: an edge is inserted there (advance_edge())
    edges  ///< along existing edges of the mesh
};

/// Resistance of a sheet to the propagation of cracks.
struct Toughness {
    /// K_Ic, Pa m^0.5, of a crack under tension along the first material axis; 0: none, hinges fail by their
    /// strength alone.
    double value = 0;
    double speed_limit = 0;  ///< m/s, largest speed of a tip
    CrackPath path = CrackPath::cut;
    std::optional<double> across = {};  ///< K_Ic, Pa m^0.5, for tension across this axis; none: `value`
    std::vector<double> factors = {};   ///< [E] factor on the toughness of each edge; empty: 1

    bool given() const { return value > 0; }
    bool has_directions() const { return across && *across != value; }
};

/// Toughness of an edge that makes `angle` (rad) with the first material axis, by hankinson() and without the
/// edge's factor.
double directional_toughness(const Toughness& toughness, double angle);

/// K_Ic, Pa m^0.5, from the fracture energy G_c (J/m^2), in plane stress: sqrt(Y G_c).
double toughness_of_energy(double energy, const Material& material);

/// The largest speed of cracks in brittle materials, m/s: 0.45 of the speed of shear waves. In glass this is
/// 1,500 m/s (Schardin 1959 measured 1,520), in PMMA 450 m/s, above the 330 m/s at which cracks in PMMA begin
/// to form micro-branches (Fineberg, Gross, Marder and Swinney 1992; Sharon, Gross and Fineberg 1995).
double usual_speed_limit(const Material& material);

}  // namespace sherd
