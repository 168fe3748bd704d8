// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/distance.h"

namespace sherd {

/// Takes the potential of two edges smoothly to zero where they become parallel, since their closest points
/// jump there: with c = |u x v|^2 of the edge vectors u and v, m = c/e (2 - c/e) below c = e and 1 above (Li
/// et al. 2020, eq. 24). Vertex-triangle pairs keep the ends of parallel edges apart.
struct EdgeMollifier {
    double threshold = 0;  ///< e, m^4

    bool active(const PairPositions& x) const;             ///< whether c < e
    double value(const PairPositions& x) const;            ///< 0 to 1
    PairPositions gradient(const PairPositions& x) const;  ///< 1/m
    PairHessian hessian(const PairPositions& x) const;     ///< 1/m^2
};

/// The mollifier with e = 1e-3 |u|^2 |v|^2 of the rest lengths (m): it leaves edges unchanged that are at
/// least about 2 degrees from parallel.
inline EdgeMollifier edge_mollifier(double rest_length0, double rest_length1) {
    return {1e-3 * rest_length0 * rest_length0 * rest_length1 * rest_length1};
}

}  // namespace sherd
