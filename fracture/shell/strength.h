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
    bending,  ///< 1/m, the paper's: magnitude of the bending strain
};

/// The strength of the hinges of a sheet. A hinge fails when its measure exceeds its strength.
struct Strength {
    Measure measure = Measure::strain;
    double along = std::numeric_limits<double>::infinity();   ///< for tension along the first material axis
    double across = std::numeric_limits<double>::infinity();  ///< for tension across it
    std::vector<double> factors = {};  ///< [E] factor on the strength of each edge; empty: 1
    double crack_tip_factor = 0.7;     ///< factor on the strength of a hinge that would continue a crack
};

/// A strength of `value`, in the measure's unit, in all directions.
Strength uniform_strength(double value, Measure measure = Measure::strain);

/// Strength or toughness of an edge at `angle` (rad) to the first material axis, by Hankinson's formula, s0
/// s1 / (s0 sin^2 p + s1 cos^2 p), where p is the angle of the tension, at 90 degrees to the edge (R. L.
/// Hankinson, US Air Service Information Circular 259, 1921). along, across: its values for tension along and
/// across the axis.
double hankinson(double along, double across, double angle);

/// Strength of a hinge whose edge makes `angle` (rad) with the first material axis, without its factor.
double directional_strength(const Strength& strength, double angle);

/// The smallest and the largest finite factor, and the number of infinite ones, of edges that never fail.
struct FactorRange {
    double least = 0, most = 0;
    std::size_t never = 0;
};
/// Returns the range of factors; none without a finite one.
std::optional<FactorRange> factor_range(std::span<const double> factors);

/// Random scatter of the strength between hinges.
struct Weibull {
    double modulus = 10;  ///< > 0; scatter decreases with it
    double area = 0;      ///< m^2, reference area; 0: every hinge has the mean strength 1
    std::uint32_t seed = 1;
};

/// Independent factors on the strengths of edges [E], from a Weibull distribution; the same seed gives the
/// same factors. Without an area their mean is 1 on any mesh. With an area, a patch of this area, which is as
/// strong as its weakest hinge, has the mean strength 1 on any mesh: a hinge, which represents a third A of
/// its faces' areas, has the mean (area / A)^(1 / modulus) (W. Weibull, 1939). Boundary edges draw random
/// numbers, too.
std::vector<double> weibull_factors(const Mesh& mesh, const Weibull& weibull);

}  // namespace sherd
