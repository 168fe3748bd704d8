// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/continuous_collision.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr double kept = 0.1;   // share of the initial gap that a motion leaves
constexpr double slack = 0.5;  // share of the gap left that is not worth another iteration
constexpr int max_iterations = 500;

}  // namespace

double approach(PairKind kind, const PairPositions& displacement) {
    // Points of the elements are weighted means of their vertices, so no two points approach by more than the
    // largest relative displacement of a vertex of one element and a vertex of the other one.
    const int first = vertices_of_first(kind);
    double most = 0;
    for (int i = 0; i < first; ++i)
        for (int j = first; j < 4; ++j)
            most = std::max(most, (displacement.col(i) - displacement.col(j)).squaredNorm());
    return std::sqrt(most);
}

bool surely_free(double distance, double way, double minimum, double clearance) {
    const double gap = distance - minimum;
    return gap > 0 && way <= gap - std::min(kept * gap, clearance);
}

double safe_fraction(PairKind kind, const PairPositions& x, const PairPositions& displacement, double minimum,
                     double clearance) {
    // Bound on the round-off of the positions in the motion and of the distance: a dozen roundings of numbers
    // of this size.
    const double size = x.cwiseAbs().maxCoeff() + displacement.cwiseAbs().maxCoeff();
    const double excluded = minimum + 32 * std::numeric_limits<double>::epsilon() * size;
    const auto gap_at = [&](double time) {
        const PairPositions at = x + time * displacement;
        return std::sqrt(squared_distance(closest_points(kind, at), at)) - excluded;
    };
    double gap = gap_at(0);
    const double bound = approach(kind, displacement) * (1 + 1e-12);  // rounded up
    if (!(gap > 0) || !std::isfinite(bound)) return 0;
    const double target = std::min(kept * gap, clearance), enough = slack * target;
    // With the additional bound / clearance iterations, every pair whose gap stays above twice the clearance
    // passes, up to a motion of about 1e6 clearances.
    const double most = std::min(max_iterations + bound / clearance, 1e6);
    double time = 0;
    for (int iteration = 0; iteration < most; ++iteration) {
        const double way = gap - target;
        if (bound * (1 - time) <= way) return 1;
        if (iteration > 0 && way <= enough) break;
        time += way / bound;
        gap = gap_at(time);
    }
    return time;
}

}  // namespace sherd
