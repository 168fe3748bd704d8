// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/distance.h"

namespace sherd {

/// A factor on the potential of two edges, which falls smoothly to zero as the edges become parallel, where
/// their closest points jump. With c = |u x v|^2 of the edge vectors u and v, it is c/e (2 - c/e) for c < e,
/// and 1 otherwise (Li et al. 2020, eq. 24). Parallel edges are still kept apart, by the vertex-triangle
/// pairs with the ends of the edges.
struct EdgeMollifier {
    double threshold = 0;  ///< e, m^4

    bool active(const PairPositions& x) const;             ///< whether c < e
    double value(const PairPositions& x) const;            ///< 0 to 1
    PairPositions gradient(const PairPositions& x) const;  ///< 1/m
    PairHessian hessian(const PairPositions& x) const;     ///< 1/m^2
};

/// The mollifier with e = 1e-3 |u|^2 |v|^2, where |u| and |v| are the rest lengths (m): at these lengths, it
/// is 1 for edges that are at least about 2 degrees from parallel.
inline EdgeMollifier edge_mollifier(double rest_length0, double rest_length1) {
    return {1e-3 * rest_length0 * rest_length0 * rest_length1 * rest_length1};
}

}  // namespace sherd
