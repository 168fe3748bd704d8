// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// Positions of the four vertices of two elements, one column for each vertex, m: a vertex and the corners of
/// a triangle (0 | 1 2 3), or the ends of two edges (0 1 | 2 3).
using PairPositions = Eigen::Matrix<double, 3, 4>;
/// Second derivatives by PairPositions; its entries are numbered column by column.
using PairHessian = Eigen::Matrix<double, 12, 12>;

/// The kinds of the two elements of a pair.
enum class PairKind { vertex_triangle, edge_edge };

/// Number of the vertices, among the four, that belong to the first element.
inline int vertices_of_first(PairKind kind) {
    return kind == PairKind::edge_edge ? 2 : 1;
}

/// The closest points of two elements: x * weights is the vector from the closest point of the second element
/// to that of the first element. Where the closest points may slide along their elements, the weights change
/// along the columns of `directions`. Vertices away from the part of an element (vertex, edge or face) that
/// holds the closest point have weight zero.
struct Closest {
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();  ///< sum: zero
    Eigen::Matrix<double, 4, 2> directions = Eigen::Matrix<double, 4, 2>::Zero();
    /// Number of columns of `directions` used: 0 vertex-vertex, 1 vertex-edge, 2 vertex-face and edge-edge.
    int freedom = 0;
};

/// The closest points of a vertex and a triangle, or of two edges. Elements may be degenerate (needles,
/// points) and parallel; the points always lie on the elements, and are the closest ones up to round-off.
/// Parallel edges may have many closest points; the ones returned include the end of an edge.
Closest closest_points(PairKind kind, const PairPositions& x);

/// Separation, m, of the elements along `direction`, a unit vector that points from the second to the first
/// element; negative if the projections of the elements on it overlap. The separation never exceeds the
/// distance of the elements, and equals the distance if `direction` is that of x * weights of their closest
/// points.
double separation(PairKind kind, const PairPositions& x, const Vector3d& direction);

/// A lower bound of the distance, m: the largest gap, along an axis, between the elements' bounding boxes;
/// negative if these overlap.
double distance_of_boxes(PairKind kind, const PairPositions& x);

/// Squared distance, m^2.
double squared_distance(const Closest& closest, const PairPositions& x);
/// Derivative of the squared distance by x, m, [3, 4]. Since the closest points minimise the distance, their
/// sliding along the elements does not contribute.
PairPositions squared_distance_gradient(const Closest& closest, const PairPositions& x);
/// Second derivative of the squared distance by x. For f(x, a) = |x w(a)|^2, with the weights w and the
/// parameters a along `directions` that minimise f, it is the Schur complement f_xx - f_xa f_aa^-1 f_ax. A
/// direction is left out if, up to round-off, it is parallel to the other one.
PairHessian squared_distance_hessian(const Closest& closest, const PairPositions& x);

}  // namespace sherd
