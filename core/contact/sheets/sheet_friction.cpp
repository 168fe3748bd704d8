// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheets/sheet_friction.h"

#include <Eigen/LU>

namespace sherd {
namespace {

using SlipMatrix = Eigen::Matrix<double, 3, 12>;

/// Share of its trace that is added to the diagonal of the inertia of a pair's edges, so that the matrix is
/// regular also if all edges are parallel.
constexpr double regularization = 1e-8;

/// Returns the matrix that maps displacements of the four vertices to the small rotation vector, rad, of the
/// elements' edges: the least-squares fit, which is exact for a rigid motion.
SlipMatrix rotation(PairKind kind, const PairPositions& x) {
    Matrix3d inertia = Matrix3d::Zero();
    SlipMatrix moments = SlipMatrix::Zero();
    const auto add_edge = [&](int a, int b) {
        const Vector3d edge = x.col(b) - x.col(a);
        inertia += edge.squaredNorm() * Matrix3d::Identity() - edge * edge.transpose();
        moments.middleCols<3>(3 * b) += cross_matrix(edge);
        moments.middleCols<3>(3 * a) -= cross_matrix(edge);
    };
    if (kind == PairKind::edge_edge) {
        add_edge(0, 1);
        add_edge(2, 3);
    } else {
        add_edge(1, 2);
        add_edge(2, 3);
        add_edge(3, 1);
    }
    inertia += regularization * inertia.trace() * Matrix3d::Identity();
    return inertia.inverse() * moments;
}

}  // namespace

SlidingPair sliding_pair(const ContactPair& pair, const PairPositions& x, double coefficient, double length,
                         const Vector3d& elastic_slip) {
    const Closest closest = closest_points(pair.kind, x);
    const double apart = std::sqrt(squared_distance(closest, x));
    const Vector3d normal =
        squared_distance_gradient(closest, x) * closest.weights / (2 * apart * closest.weights.squaredNorm());
    const double force =
        -pair.stiffness * pair.mollifier.value(x) * pair.barrier().slope(apart - pair.minimum());
    const Matrix3d tangent = Matrix3d::Identity() - normal * normal.transpose();
    const double smoothing = smoothing_speed * length;
    SlidingPair sliding{pair.kind,
                        pair.vertices,
                        apart * cross_matrix(normal) * rotation(pair.kind, x),
                        tangent,
                        {coefficient * force, smoothing, smoothing * (tangent * elastic_slip)}};
    for (int i = 0; i < 4; ++i) sliding.slip.middleCols<3>(3 * i) += closest.weights[i] * tangent;
    return sliding;
}

PairPositions SlidingPair::gradient(const PairPositions& moved) const {
    const Eigen::Matrix<double, 12, 1> local = slip.transpose() * friction.gradient(slip * moved.reshaped());
    return local.reshaped(3, 4);
}

PairHessian SlidingPair::hessian(const PairPositions& moved) const {
    return slip.transpose() * friction.hessian(slip * moved.reshaped(), tangent) * slip;
}

PairPositions SlidingPairs::gather(std::size_t i, const Positions& x) const {
    PairPositions moved;
    for (int v = 0; v < 4; ++v) {
        const Index vertex = pairs[i].vertices[v];
        if (vertex < first)
            moved.col(v) = colliders.col(vertex);
        else
            moved.col(v) = x.col(vertex - first) - start.col(vertex);
    }
    return moved;
}

void SheetFriction::begin(const StepContext& step) {
    elements.pairs.clear();
    elements.first = contact.surface().collider_vertices();
    elements.start = contact.at_start(shell.position);
    elements.colliders =
        contact.at_end(shell.position).leftCols(elements.first) - elements.start.leftCols(elements.first);
    for (const ContactPair& pair : contact.active_pairs_at_start(shell.position)) {
        const ContactCollider* collider = contact.surface().collider_of(pair.kind, pair.vertices);
        const double own = collider ? collider->friction : coefficient;
        if (own > 0)
            elements.pairs.push_back(sliding_pair(pair, columns(elements.start, pair.vertices), own,
                                                  step.length,
                                                  elastic_slip.slip_of({pair.kind, pair.vertices})));
    }
}

void SheetFriction::finish(const Positions& x) {
    elastic_slip.clear();
    for (std::size_t i = 0; i < elements.size(); ++i)
        elastic_slip.keep(elements.pairs[i].key(),
                          elements.pairs[i].elastic_slip_after(elements.gather(i, x)));
    elastic_slip.sort();
}

double SheetFriction::friction_loss(const Positions& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const PairPositions moved = elements.gather(i, x);
        sum += elements.gradient(i, moved).cwiseProduct(moved).sum();
    }
    return sum;
}

void SheetFriction::add_contacts(const Positions&, bool, std::vector<std::pair<Index, Index>>& all) const {
    add_patterns(elements, all);
}

}  // namespace sherd
