// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/barrier/contact_pair.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdint>

namespace sherd {
namespace {

using PairVector = Eigen::Matrix<double, 12, 1>;

PairHessian positive_part(const PairHessian& matrix) {
    const Eigen::SelfAdjointEigenSolver<PairHessian> eigen(matrix);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
           eigen.eigenvectors().transpose();
}

/// Second derivative of the distance, 1/m, where `gradient` is the first one.
PairHessian distance_hessian(const Closest& closest, const PairPositions& x, double distance,
                             const PairVector& gradient) {
    return (0.5 * squared_distance_hessian(closest, x) - gradient * gradient.transpose()) / distance;
}

}  // namespace

void sort(std::vector<ContactPair>& pairs) {
    // The short keys are compared and moved, which is faster than to move pairs.
    struct Key {
        std::array<std::uint64_t, 2> order;
        std::size_t pair;
    };
    std::vector<Key> keys;
    keys.reserve(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [a, b, c, d] = pairs[i].vertices;
        const auto both = [](std::uint64_t high, std::uint64_t low) { return high << 32 | low; };
        const std::uint64_t kind = static_cast<std::uint64_t>(pairs[i].kind) << 63;
        keys.push_back({{kind | both(a, b), both(c, d)}, i});
    }
    std::ranges::sort(keys, [](const Key& one, const Key& other) {
        return one.order[0] != other.order[0] ? one.order[0] < other.order[0] : one.order[1] < other.order[1];
    });
    std::vector<ContactPair> sorted;
    sorted.reserve(pairs.size());
    for (const Key& key : keys) sorted.push_back(pairs[key.pair]);
    pairs = std::move(sorted);
}

double distance(const ContactPair& pair, const PairPositions& x) {
    return std::sqrt(squared_distance(closest_points(pair.kind, x), x));
}

bool within(double limit, const ContactPair& pair, const PairPositions& x) {
    return distance_of_boxes(pair.kind, x) < limit && distance(pair, x) < limit;
}

double value(const ContactPair& pair, const PairPositions& x) {
    const double apart = distance(pair, x);
    if (apart >= pair.activation_distance) return 0;
    return pair.stiffness * pair.mollifier.value(x) * pair.barrier().value(apart - pair.minimum());
}

PairPositions gradient(const ContactPair& pair, const PairPositions& x) {
    const Closest closest = closest_points(pair.kind, x);
    const double apart = std::sqrt(squared_distance(closest, x)), gap = apart - pair.minimum();
    if (apart >= pair.activation_distance) return PairPositions::Zero();
    const PairPositions by_x = squared_distance_gradient(closest, x) / (2 * apart);
    const Barrier barrier = pair.barrier();
    PairPositions sum = pair.mollifier.value(x) * barrier.slope(gap) * by_x;
    if (pair.mollifier.active(x)) sum += barrier.value(gap) * pair.mollifier.gradient(x);
    return pair.stiffness * sum;
}

PairHessian hessian(const ContactPair& pair, const PairPositions& x, bool convex) {
    const Closest closest = closest_points(pair.kind, x);
    const double apart = std::sqrt(squared_distance(closest, x)), gap = apart - pair.minimum();
    if (apart >= pair.activation_distance) return PairHessian::Zero();
    const PairVector by_x = (squared_distance_gradient(closest, x) / (2 * apart)).reshaped();
    const Barrier barrier = pair.barrier();
    const bool mollified = pair.mollifier.active(x);
    PairHessian sum = barrier.curvature(gap) * by_x * by_x.transpose();
    if (!convex || mollified) sum += barrier.slope(gap) * distance_hessian(closest, x, apart, by_x);
    if (mollified) {
        const PairVector turn = pair.mollifier.gradient(x).reshaped();
        const PairHessian mixed = by_x * turn.transpose();
        sum = pair.mollifier.value(x) * sum + barrier.slope(gap) * (mixed + mixed.transpose()) +
              barrier.value(gap) * pair.mollifier.hessian(x);
        if (convex) sum = positive_part(sum);
    }
    return pair.stiffness * sum;
}

}  // namespace sherd
