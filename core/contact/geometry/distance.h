// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The four vertices of two elements, one column each, m: a vertex and a triangle's three (0 | 1 2 3), or the
/// ends of two edges (0 1 | 2 3).
using PairPositions = Eigen::Matrix<double, 3, 4>;
/// Second derivatives by them, coordinate fastest.
using PairHessian = Eigen::Matrix<double, 12, 12>;

/// Which two elements.
enum class PairKind { vertex_triangle, edge_edge };

/// How many of the four vertices are the first element's.
inline int vertices_of_first(PairKind kind) {
    return kind == PairKind::edge_edge ? 2 : 1;
}

/// Where two elements come closest: the vector from the second's point to the first's is x weights. Where the
/// closest points may slide along their elements, the weights do so along `directions`; which vertices have a
/// weight tells the case that the pair falls into.
struct Closest {
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();  ///< sum zero
    Eigen::Matrix<double, 4, 2> directions = Eigen::Matrix<double, 4, 2>::Zero();
    int freedom = 0;  ///< directions in use: 0 vertex-vertex, 1 vertex-edge, 2 vertex-face and edge-edge
};

/// The closest points of a vertex and a triangle, or of two edges. Elements may be degenerate (needles,
/// points) and parallel; the points found always lie on them, and are the closest up to round-off. Of
/// parallel edges, which have many closest points, they are at an end.
Closest closest_points(PairKind kind, const PairPositions& x);

/// How far apart the elements are along a unit vector from the second to the first, m; negative if they
/// overlap there. Whatever the direction, no more than their distance, and along x weights just that.
double separation(PairKind kind, const PairPositions& x, const Vector3d& direction);

/// Squared distance, m^2.
double squared_distance(const Closest& closest, const PairPositions& x);
/// Its derivative, m, [3, 4]. The closest points minimise the distance, so their own motion does not count.
PairPositions squared_distance_gradient(const Closest& closest, const PairPositions& x);
/// Its second derivative: of f(x, a) = |x w(a)|^2, minimal over the parameters a, it is the Schur complement
/// f_xx - f_xa f_aa^-1 f_ax. Directions that are parallel to round-off are left out.
PairHessian squared_distance_hessian(const Closest& closest, const PairPositions& x);

}  // namespace sherd
