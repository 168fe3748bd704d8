// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// The measure by which a hinge fails: see HingeMeasures.
enum class Measure {
    strain,   ///< surface strain over half the thickness, 1/m
    stress,   ///< surface stress, Pa
    bending,  ///< magnitude of the bending strain, 1/m: the paper's measure
};

/// The strength of the hinges of a sheet. A hinge fails when its measure exceeds its strength, which has the
/// measure's unit.
struct Strength {
    Measure measure = Measure::strain;
    double along = std::numeric_limits<double>::infinity();   ///< for tension along the first material axis
    double across = std::numeric_limits<double>::infinity();  ///< for tension across this axis
    std::vector<double> factors = {};  ///< [E] factor on the strength of each edge; empty: 1
    double crack_tip_factor = 0.7;     ///< factor on the strength of a hinge that would continue a crack
};

/// A strength of `value`, in the measure's unit, in all directions.
Strength uniform_strength(double value, Measure measure = Measure::strain);

/// Strength or toughness of an edge at `angle` (rad) to the first material axis, by Hankinson's formula, s0
/// s1 / (s0 sin^2 p + s1 cos^2 p) (R. L. Hankinson, US Air Service Information Circular 259, 1921). Here p is
/// the angle from the axis to the direction of the tension, at 90 degrees to the edge; s0 = along and s1 =
/// across are the values for tension along and across the axis.
double hankinson(double along, double across, double angle);

/// Strength of a hinge whose edge makes `angle` (rad) with the first material axis, without the edge's
/// factor.
double directional_strength(const Strength& strength, double angle);

/// The smallest and the largest finite factor, and the number of infinite factors: their edges never fail.
struct FactorRange {
    double least = 0, most = 0;
    std::size_t never = 0;
};
/// Returns the range of factors; nothing if no factor is finite.
std::optional<FactorRange> factor_range(std::span<const double> factors);

/// Random scatter of the strength between hinges.
struct Weibull {
    double modulus = 10;  ///< > 0; scatter decreases with it
    double area = 0;      ///< m^2, reference area; 0: the mean factor of every hinge is 1
    std::uint32_t seed = 1;
};

/// Returns independent random factors on the strengths of edges, [E], from a Weibull distribution; the same
/// seed gives the same factors. If weibull.area is 0, their mean is 1 on any mesh. If it is positive, a patch
/// of this area, which is as strong as its weakest hinge, has the mean factor 1 on any mesh: a hinge
/// represents an area A, a third of its faces' areas, and its factor has the mean (area / A)^(1 / modulus)
/// (W. Weibull, 1939). Boundary edges draw random numbers, too.
std::vector<double> weibull_factors(const Mesh& mesh, const Weibull& weibull);

}  // namespace sherd
