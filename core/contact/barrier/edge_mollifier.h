// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/distance.h"

namespace sherd {

/// Takes the potential of two edges smoothly to zero where they become parallel, since there their closest
/// points jump: with c = |u x v|^2 of the edge vectors, m = c/e (2 - c/e) below c = e, 1 from there on (Li et
/// al. 2020, eq. 24). The ends of parallel edges are held by vertex-triangle pairs.
struct EdgeMollifier {
    double threshold = 0;  ///< e, m^4

    bool active(const PairPositions& x) const;             ///< c < e
    double value(const PairPositions& x) const;            ///< 0 to 1
    PairPositions gradient(const PairPositions& x) const;  ///< 1/m
    PairHessian hessian(const PairPositions& x) const;     ///< 1/m^2
};

/// For edges that are at least about 2 degrees apart untouched: e = 1e-3 |u|^2 |v|^2 of the lengths at rest.
inline EdgeMollifier edge_mollifier(double rest_length0, double rest_length1) {
    return {1e-3 * rest_length0 * rest_length0 * rest_length1 * rest_length1};
}

}  // namespace sherd
