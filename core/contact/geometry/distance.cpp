// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/distance.h"

#include <algorithm>
#include <limits>

namespace sherd {
namespace {

using Direction = Eigen::Vector4d;

/// Squared sine of the angle below which two directions, known to a relative error of 1e-16, count as
/// parallel.
constexpr double parallel = 1e-28;

/// The closest points of the vertex in column p of x and the edge from column a to column b.
Closest vertex_edge(const PairPositions& x, int p, int a, int b) {
    const Vector3d along = x.col(b) - x.col(a);
    const double way = (x.col(p) - x.col(a)).dot(along), length = along.squaredNorm();
    const double parameter = way > 0 ? (way < length ? way / length : 1) : 0;
    const double sign = p < a ? 1 : -1;  // the first element's weights are positive
    Closest closest;
    closest.weights[p] = sign;
    closest.weights[a] = -sign * (1 - parameter);
    closest.weights[b] = -sign * parameter;
    if (way > 0 && way < length) {
        closest.freedom = 1;
        closest.directions(a, 0) = sign;
        closest.directions(b, 0) = -sign;
    }
    return closest;
}

/// Returns the parameters (s, t) that minimise |r + s u + t v|, for u and v that are not parallel. The
/// orthogonalisation keeps digits that the normal equations would lose for needle-shaped triangles.
Vector2d minimising(const Vector3d& r, const Vector3d& u, const Vector3d& v) {
    const double projection = u.dot(v) / u.squaredNorm();
    const Vector3d across = v - projection * u;
    const double t = -r.dot(across) / across.squaredNorm();
    return {-r.dot(u) / u.squaredNorm() - t * projection, t};
}

/// The closest points among the candidates that were passed to the constructor and to improve().
struct Best {
    const PairPositions& x;
    Closest closest;
    double distance;  ///< m^2, squared distance

    Best(const Closest& first, const PairPositions& x)
        : x(x), closest(first), distance(squared_distance(first, x)) {}
    void improve(const Closest& other) {
        const double its_distance = squared_distance(other, x);
        if (!(its_distance < distance)) return;
        closest = other;
        distance = its_distance;
    }
};

/// The closest points of the lines through two edges, or of a vertex and the plane of a triangle.
Closest both_inside(PairKind kind, const PairPositions& x) {
    Closest closest;
    closest.freedom = 2;
    if (kind == PairKind::edge_edge) {
        const Vector2d at = minimising(x.col(0) - x.col(2), x.col(1) - x.col(0), x.col(2) - x.col(3));
        closest.weights << 1 - at[0], at[0], at[1] - 1, -at[1];
        closest.directions << -1, 0, 1, 0, 0, 1, 0, -1;
    } else {
        const Vector2d at = minimising(x.col(0) - x.col(1), x.col(1) - x.col(2), x.col(1) - x.col(3));
        closest.weights << 1, at[0] + at[1] - 1, -at[0], -at[1];
        closest.directions << 0, 0, 1, 1, -1, 0, 0, -1;
    }
    return closest;
}

}  // namespace

double separation(PairKind kind, const PairPositions& x, const Vector3d& direction) {
    const Eigen::RowVector4d height = direction.transpose() * x;
    return kind == PairKind::edge_edge ? std::min(height[0], height[1]) - std::max(height[2], height[3])
                                       : height[0] - std::max({height[1], height[2], height[3]});
}

double distance_of_boxes(PairKind kind, const PairPositions& x) {
    const int first = vertices_of_first(kind);
    double apart = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        double low = x(axis, 0), high = low, other_low = x(axis, first), other_high = other_low;
        for (int i = 1; i < first; ++i) {
            low = std::min(low, x(axis, i));
            high = std::max(high, x(axis, i));
        }
        for (int i = first + 1; i < 4; ++i) {
            other_low = std::min(other_low, x(axis, i));
            other_high = std::max(other_high, x(axis, i));
        }
        apart = std::max({apart, low - other_high, other_low - high});
    }
    return apart;
}

double squared_distance(const Closest& closest, const PairPositions& x) {
    // Differences of positions are taken first, which keeps digits far from the origin.
    const auto part = [&](int i) { return closest.weights[i] * (x.col(i) - x.col(0)); };
    return Vector3d(part(1) + part(2) + part(3)).squaredNorm();
}

Closest closest_points(PairKind kind, const PairPositions& x) {
    const bool edges = kind == PairKind::edge_edge;
    Best best(edges ? vertex_edge(x, 0, 2, 3) : vertex_edge(x, 0, 1, 2), x);
    if (edges) {
        best.improve(vertex_edge(x, 1, 2, 3));
        best.improve(vertex_edge(x, 2, 0, 1));
        best.improve(vertex_edge(x, 3, 0, 1));
    } else {
        best.improve(vertex_edge(x, 0, 2, 3));
        best.improve(vertex_edge(x, 0, 3, 1));
    }
    const Closest inside = both_inside(kind, x);
    const Direction w = edges ? Direction(inside.weights.cwiseProduct(Direction(1, 1, -1, -1)))
                              : Direction(inside.weights.cwiseProduct(Direction(1, -1, -1, -1)));
    if ((w.array() > 0).all()) best.improve(inside);  // false for NaN, the result for parallel edges
    return best.closest;
}

PairPositions squared_distance_gradient(const Closest& closest, const PairPositions& x) {
    const Eigen::Matrix3d edges = x.rightCols<3>().colwise() - x.col(0);
    return 2 * (edges * closest.weights.tail<3>()) * closest.weights.transpose();
}

PairHessian squared_distance_hessian(const Closest& closest, const PairPositions& x) {
    const auto& w = closest.weights;
    PairHessian h = PairHessian::Zero();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) h.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(2 * w[i] * w[j]);
    const Eigen::Matrix3d edges = x.rightCols<3>().colwise() - x.col(0);
    const Vector3d between = edges * w.tail<3>();
    // With orthogonal directions, the matrix f_aa of the header is diagonal.
    Direction first = closest.directions.col(0), second = closest.directions.col(1);
    if (closest.freedom == 2) {
        const Vector3d u = edges * first.tail<3>(), v = edges * second.tail<3>();
        second -= u.dot(v) / u.squaredNorm() * first;
    }
    for (const Direction& a : {first, second}) {
        const Vector3d slide = edges * a.tail<3>();
        if (slide.squaredNorm() <= parallel * edges.squaredNorm()) continue;
        Eigen::Matrix<double, 12, 1> mixed;  // f_xa / 2
        for (int i = 0; i < 4; ++i) mixed.segment<3>(3 * i) = w[i] * slide + a[i] * between;
        h.noalias() -= 2 / slide.squaredNorm() * mixed * mixed.transpose();
    }
    return h;
}

}  // namespace sherd
