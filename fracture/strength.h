// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// By what a hinge is judged, see HingeMeasures.
enum class Measure {
    strain,   ///< surface strain over half the thickness, 1/m
    stress,   ///< surface stress, Pa
    bending,  ///< the paper's: magnitude of the bending strain, 1/m
};

/// What the hinges of a sheet withstand. A hinge fails when its measure exceeds its strength.
struct Strength {
    Measure measure = Measure::strain;
    double along = std::numeric_limits<double>::infinity();   ///< pulled along the first material axis
    double across = std::numeric_limits<double>::infinity();  ///< pulled across it
    std::vector<double> factors = {};  ///< [E] times the strength of each edge; empty: one
    double crack_tip_factor = 0.7;     ///< times the strength of a hinge that would continue a crack
};

/// The same strength in all directions, in the measure's unit.
Strength uniform_strength(double value, Measure measure = Measure::strain);

/// Strength of a hinge whose edge makes `angle` (rad) with the first material axis, without its factor.
/// Between the axes it follows Hankinson's formula, s0 s1 / (s0 sin^2 p + s1 cos^2 p) for a pull at the angle
/// p, which is at 90 degrees to the edge (R. L. Hankinson, US Air Service Information Circular 259, 1921).
double directional_strength(const Strength& strength, double angle);

/// Scatter of the strength between hinges.
struct Weibull {
    double modulus = 10;  ///< > 0; the larger the less scatter
    double area = 0;      ///< m^2; 0: every hinge has the mean strength 1
    std::uint32_t seed = 1;
};

/// Independent factors of the edges' strengths [E], from a Weibull distribution, the same for the same seed.
/// Without an area their mean is 1, whatever the mesh. With one, a patch of this area, which is as strong as
/// its weakest hinge, has the mean strength 1 whatever the mesh: a hinge that a third A of its faces' areas
/// belongs to has the mean (area / A)^(1 / modulus) (W. Weibull, 1939). Boundary edges draw too.
std::vector<double> weibull_factors(const Mesh& mesh, const Weibull& weibull);

}  // namespace sherd
