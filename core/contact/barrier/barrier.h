// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sherd {

/// A second, stiffer spring, which acts in addition to the first one where the gap is less than share() times
/// the range.
struct SecondSpring {
    std::uint8_t degree = 0;    ///< 0: no second spring
    std::uint8_t halvings = 1;  ///< share() is 2 to the power of -halvings

    /// Stiffness of the second spring over that of the first one.
    double stiffness() const { return degree == 0 ? 0 : std::pow(64, degree); }
    double share() const { return std::ldexp(1, -halvings); }
};

/// The barrier potential of a gap between two elements: it is infinite at zero gap, zero for gaps of at least
/// `range`, and twice continuously differentiable (the clamped logarithm of incremental potential contact, Li
/// et al. 2020, eq. 6). It is scaled so that at a gap of half the range its force equals the force of a
/// spring of stiffness 1 N/m that is compressed by half the range. If `spring` is true, the potential is that
/// of such a spring, of rest length `range`, and of `second_spring`: explicit steps need a bounded stiffness.
/// ContactPair multiplies the potential by its stiffness.
struct Barrier {
    double range;  ///< m
    bool spring = false;
    SecondSpring second_spring = {};

    double value(double gap) const {  ///< J, at a stiffness of 1 N/m
        if (gap >= range) return 0;
        if (spring)
            return 0.5 * (range - gap) * (range - gap) +
                   0.5 * second_spring.stiffness() * second_compression(gap) * second_compression(gap);
        if (gap <= 0) return std::numeric_limits<double>::infinity();
        return -scale * (range - gap) * (range - gap) * std::log(gap / range);
    }
    double slope(double gap) const {  ///< N; the force is its negative
        if (gap >= range) return 0;
        if (spring) return gap - range - second_spring.stiffness() * second_compression(gap);
        const double left = range - gap;
        return scale * left * (2 * std::log(gap / range) - left / gap);
    }
    double curvature(double gap) const {  ///< N/m, positive
        if (gap >= range) return 0;
        if (spring) return second_compression(gap) > 0 ? 1 + second_spring.stiffness() : 1;
        const double ratio = (range - gap) / gap;
        return scale * (-2 * std::log(gap / range) + ratio * (4 + ratio));
    }

  private:
    /// Compression of the second spring, m.
    double second_compression(double gap) const {
        return second_spring.degree == 0 ? 0 : std::max(0.0, second_spring.share() * range - gap);
    }

    static constexpr double scale = 0.5 / (0.5 + 0.693147180559945309);  // slope(range / 2) is -range / 2
};

}  // namespace sherd
