// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_polynomial.h"

#include <algorithm>
#include <limits>

#include "core/elements/triple_product.h"

namespace sherd {
namespace {

using Spring = CubicPolynomial::Spring;

/// Springs by their first vertex, which is the lower one.
std::vector<Spring> by_first(std::span<const Spring> springs, Eigen::Index vertices) {
    std::vector<std::size_t> next(vertices + 1, 0);
    for (const Spring& spring : springs) ++next[std::min(spring.first, spring.second) + 1];
    for (Eigen::Index v = 0; v < vertices; ++v) next[v + 1] += next[v];
    std::vector<Spring> sorted(springs.size());
    for (const auto& [a, b, stiffness, convex] : springs) {
        const auto [first, second] = std::minmax(a, b);
        sorted[next[first]++] = {first, second, stiffness, convex};
    }
    return sorted;
}

/// The sum of springs between each two vertices, in linear time.
std::vector<Spring> merged(std::span<const Spring> springs, Eigen::Index vertices) {
    std::vector<Spring> sums;
    std::vector<std::size_t> place(vertices, 0);  // of the last spring to a vertex in `sums`
    for (const Spring& spring : by_first(springs, vertices)) {
        std::size_t& at = place[spring.second];
        if (at < sums.size() && sums[at].first == spring.first && sums[at].second == spring.second) {
            sums[at].stiffness += spring.stiffness;
            sums[at].convex += spring.convex;
        } else {
            at = sums.size();
            sums.push_back(spring);
        }
    }
    return sums;
}

}  // namespace

CubicPolynomial::CubicPolynomial(std::span<const Spring> all, std::vector<Triple> triples, double constant,
                                 const Positions& rest)
    : springs(merged(all, rest.cols())), triples(std::move(triples)), constant(constant) {
    double size = 0;
    for (const auto& [a, b, stiffness, convex] : springs)
        size += std::abs(stiffness) * (rest.col(a) - rest.col(b)).squaredNorm();
    error = 2 * std::numeric_limits<double>::epsilon() * size;
}

double CubicPolynomial::value(const Positions& x) const {
    double sum = 0;
    for (const auto& [a, b, stiffness, convex] : springs)
        sum += 0.5 * stiffness * (x.col(a) - x.col(b)).squaredNorm();
    for (const auto& [vertices, factor] : triples) sum -= factor * triple_product(columns(x, vertices));
    return sum + constant;
}

void CubicPolynomial::add_gradient(const Positions& x, Positions& gradient) const {
    for (const auto& [a, b, stiffness, convex] : springs) {
        const Vector3d pull = stiffness * (x.col(a) - x.col(b));
        gradient.col(a) += pull;
        gradient.col(b) -= pull;
    }
    for (const auto& [vertices, factor] : triples) {
        const HingePositions local = factor * triple_gradient(columns(x, vertices));
        for (int v = 0; v < 4; ++v) gradient.col(vertices[v]) -= local.col(v);
    }
}

void CubicPolynomial::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    VectorXd diagonal = VectorXd::Zero(x.cols());
    for (const auto& [a, b, stiffness, convex] : springs) {
        const double value = curvature == Curvature::exact ? stiffness : convex;
        diagonal[a] += value;
        diagonal[b] += value;
        hessian.add(b, a, -value * Matrix3d::Identity());
    }
    for (Index v = 0; v < static_cast<Index>(diagonal.size()); ++v)
        if (diagonal[v] != 0) hessian.add(v, v, diagonal[v] * Matrix3d::Identity());
    if (curvature == Curvature::convex) return;
    for (const auto& [vertices, factor] : triples) {
        HingeHessian local = HingeHessian::Zero();
        add_triple_hessian(-factor, columns(x, vertices), local);
        for (int a = 0; a < 4; ++a)  // nothing is on the diagonal
            for (int b = 0; b < a; ++b)
                hessian.add(vertices[a], vertices[b], local.block<3, 3>(3 * a, 3 * b));
    }
}

void CubicPolynomial::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const Spring& spring : springs) pairs.emplace_back(spring.first, spring.second);
    for (const Triple& triple : triples) add_pairs(pairs, triple.vertices);
}

}  // namespace sherd
