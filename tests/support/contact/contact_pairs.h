// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "core/contact/geometry/distance.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

inline constexpr PairKind pair_kinds[] = {PairKind::vertex_triangle, PairKind::edge_edge};

using LongPositions = Eigen::Matrix<long double, 3, 4>;
using LongVector = Eigen::Matrix<long double, 3, 1>;

inline long double squared_distance_of_points(const LongVector& a, const LongVector& b) {
    return (a - b).squaredNorm();
}

/// Point of the segment from a to b closest to p.
inline LongVector closest_on_segment(const LongVector& p, const LongVector& a, const LongVector& b) {
    const LongVector along = b - a;
    const long double length = along.squaredNorm();
    if (length == 0) return a;
    return a + std::clamp((p - a).dot(along) / length, 0.0L, 1.0L) * along;
}

/// Smallest distance between the two elements of a pair, whose vertices are the columns of x: by ternary
/// search along one element, since the distance to a convex set is convex; in long double. Slow, but without
/// case distinctions.
inline long double searched_distance(PairKind kind, const LongPositions& x) {
    const auto search = [](const auto& f) {
        long double low = 0, high = 1;
        for (int i = 0; i < 120; ++i) {
            const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
            (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
        }
        return std::min({f(0.5L * (low + high)), f(0.0L), f(1.0L)});
    };
    const auto on = [&](int a, int b, long double s) {
        return LongVector((1 - s) * x.col(a) + s * x.col(b));
    };
    const auto to_segment = [](const LongVector& p, const LongVector& a, const LongVector& b) {
        return squared_distance_of_points(p, closest_on_segment(p, a, b));
    };
    if (kind == PairKind::edge_edge)
        return std::sqrt(search([&](long double s) { return to_segment(on(0, 1, s), x.col(2), x.col(3)); }));
    return std::sqrt(search([&](long double s) {  // triangle: segments from column 1 to side 2-3
        return to_segment(x.col(0), x.col(1), on(2, 3, s));
    }));
}

/// Positions of the vertices of `random_ones` random pairs: in turn anywhere, coplanar, parallel, nearly
/// parallel, with a needle for a triangle, near a corner, with an edge of length zero, and very near.
inline std::vector<PairPositions> adversarial_pairs(int random_ones) {
    Random random(7);
    std::vector<PairPositions> pairs;
    for (int i = 0; i < random_ones; ++i) {
        PairPositions x = random.matrix<PairPositions>(1);
        switch (i % 8) {
            case 1:  // coplanar
                x.row(2).setZero();
                break;
            case 2:  // parallel edges
                x.col(3) = x.col(2) + random.uniform(-2, 2) * (x.col(1) - x.col(0));
                break;
            case 3:  // nearly parallel
                x.col(3) = x.col(2) + (x.col(1) - x.col(0)) + random.matrix<Vector3d>(1e-9);
                break;
            case 4:  // triangle that is a needle
                x.col(3) = 0.5 * (x.col(1) + x.col(2)) + random.matrix<Vector3d>(1e-9);
                break;
            case 5:  // near a corner of the triangle, or an end of the other edge
                x.col(0) = x.col(2) + 0.1 * random.matrix<Vector3d>(1);
                break;
            case 6:  // edge of length zero
                x.col(3) = x.col(2);
                break;
            case 7:  // very near the middle of the triangle
                x.col(0) = (x.col(1) + x.col(2) + x.col(3)) / 3 + random.matrix<Vector3d>(1e-3);
                break;
        }
        pairs.push_back(x);
    }
    return pairs;
}

}  // namespace sherd::test
