// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The four vertices of two elements, one column each, m: a vertex and the three of a triangle (0 | 1 2 3),
/// or the ends of two edges (0 1 | 2 3).
using PairPositions = Eigen::Matrix<double, 3, 4>;
/// Second derivatives by PairPositions, coordinate fastest.
using PairHessian = Eigen::Matrix<double, 12, 12>;

/// The kinds of the two elements of a pair.
enum class PairKind { vertex_triangle, edge_edge };

/// How many of the four vertices belong to the first element.
inline int vertices_of_first(PairKind kind) {
    return kind == PairKind::edge_edge ? 2 : 1;
}

/// The closest points of two elements: the vector from the second element's point to the first's is x
/// weights. Where the closest points may slide along their elements, the weights change along `directions`.
/// The vertices with a nonzero weight determine the case of the pair.
struct Closest {
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();  ///< weights with sum zero
    Eigen::Matrix<double, 4, 2> directions = Eigen::Matrix<double, 4, 2>::Zero();
    int freedom = 0;  ///< directions used: 0 vertex-vertex, 1 vertex-edge, 2 vertex-face and edge-edge
};

/// The closest points of a vertex and a triangle, or of two edges. Elements may be degenerate (needles,
/// points) and parallel; the points always lie on them, and are the closest up to round-off. Parallel edges
/// have many closest points; one at an end is returned.
Closest closest_points(PairKind kind, const PairPositions& x);

/// Separation, m, of the elements along a unit vector from the second to the first; negative if their
/// projections overlap. It never exceeds their distance, and equals it along x weights.
double separation(PairKind kind, const PairPositions& x, const Vector3d& direction);

/// A lower bound of the distance, m: that of the elements' bounding boxes.
double distance_of_boxes(PairKind kind, const PairPositions& x);

/// Squared distance, m^2.
double squared_distance(const Closest& closest, const PairPositions& x);
/// Derivative of the squared distance, m, [3, 4]. Since the closest points minimise the distance, their own
/// motion does not contribute.
PairPositions squared_distance_gradient(const Closest& closest, const PairPositions& x);
/// Second derivative of the squared distance. For f(x, a) = |x w(a)|^2, minimal over the parameters a, it is
/// the Schur complement f_xx - f_xa f_aa^-1 f_ax. Directions that are parallel up to round-off are left out.
PairHessian squared_distance_hessian(const Closest& closest, const PairPositions& x);

}  // namespace sherd
