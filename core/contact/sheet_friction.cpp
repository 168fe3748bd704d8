// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheet_friction.h"

#include <Eigen/LU>

namespace sherd {
namespace {

using SlipMatrix = Eigen::Matrix<double, 3, 12>;

/// Of the pair's inertia against turning, to bear elements that are as thin as a line.
constexpr double regularization = 1e-8;

/// The small rotation, rad, that the elements' edges have made, as a matrix on the vertices' displacements:
/// the one that fits best, which is exact for a rigid motion.
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

SlidingPair sliding_pair(const ContactPair& pair, const PairPositions& x, double coefficient, double step) {
    const Closest closest = closest_points(pair.kind, x);
    const double apart = std::sqrt(squared_distance(closest, x));
    const Vector3d normal =
        squared_distance_gradient(closest, x) * closest.weights / (2 * apart * closest.weights.squaredNorm());
    const double force =
        -pair.stiffness * pair.mollifier.value(x) * pair.barrier().slope(apart - pair.minimum());
    SlidingPair sliding{pair.vertices,
                        apart * cross_matrix(normal) * rotation(pair.kind, x),
                        Matrix3d::Identity() - normal * normal.transpose(),
                        {coefficient * force, smoothing_speed * step}};
    for (int i = 0; i < 4; ++i) sliding.slip.middleCols<3>(3 * i) += closest.weights[i] * sliding.tangent;
    return sliding;
}

SheetFriction::SheetFriction(const Sheet& sheet, const SheetContact& contact, double coefficient, double step)
    : first(contact.surface().solid_vertices()),
      start(contact.at_start(sheet.position)),
      solids(contact.at_end(sheet.position).leftCols(first) - start.leftCols(first)) {
    for (const ContactPair& pair : contact.touching_at_start(sheet.position)) {
        const ContactSolid* solid = contact.surface().solid_of(pair.kind, pair.vertices);
        const double own = solid ? solid->friction : coefficient;
        if (own > 0) pairs.push_back(sliding_pair(pair, pair_positions(start, pair.vertices), own, step));
    }
}

Vector3d SheetFriction::slip(const SlidingPair& pair, const Positions& x) const {
    PairPositions moved;
    for (int i = 0; i < 4; ++i) {
        const Index vertex = pair.vertices[i];
        if (vertex < first)
            moved.col(i) = solids.col(vertex);
        else
            moved.col(i) = x.col(vertex - first) - start.col(vertex);
    }
    return pair.slip * moved.reshaped();
}

double SheetFriction::value(const Positions& x) const {
    double sum = 0;
    for (const SlidingPair& pair : pairs) sum += pair.friction.value(slip(pair, x));
    return sum;
}

void SheetFriction::add_gradient(const Positions& x, Positions& gradient) const {
    for (const SlidingPair& pair : pairs) {
        const Eigen::Matrix<double, 12, 1> local =
            pair.slip.transpose() * pair.friction.gradient(slip(pair, x));
        for (int i = 0; i < 4; ++i)
            if (const Index vertex = pair.vertices[i]; vertex >= first)
                gradient.col(vertex - first) += local.segment<3>(3 * i);
    }
}

void SheetFriction::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    for (const SlidingPair& pair : pairs)
        add_element(hessian, pair.vertices,
                    PairHessian(pair.slip.transpose() * pair.friction.hessian(slip(pair, x), pair.tangent) *
                                pair.slip),
                    first);
}

void SheetFriction::add_contacts(const Positions&, bool, std::vector<std::pair<Index, Index>>& all) const {
    for (const SlidingPair& pair : pairs) add_pairs(all, pair.vertices, first);
}

}  // namespace sherd
