// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/hessian_patch.h"

#include <numeric>
#include <span>

namespace sherd {
namespace {

/// Sets `matrix` to the Hessian at x; if `elsewhere` is not null, the contribution of contact is the mean of
/// the contributions at x and at `elsewhere`.
void set_hessian(const Potential& potential, const Positions& x, const Positions* elsewhere,
                 Curvature curvature, BlockMatrix& matrix) {
    potential.hessian(x, curvature, matrix);
    if (elsewhere == nullptr) return;
    std::vector<double> rest(matrix.values().begin(), matrix.values().end());
    potential.contact_hessian(x, curvature, matrix);
    const std::span<const double> of_contact = matrix.values();
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = 2 * rest[i] - of_contact[i];
    potential.contact_hessian(*elsewhere, curvature, matrix);
    matrix.blend(rest, matrix.values(), 0.5);
}

}  // namespace

VertexGraph::VertexGraph(Index vertices, const std::vector<std::pair<Index, Index>>& pairs) {
    std::vector<std::size_t> named(vertices + 1, 0);
    for (const auto& [i, j] : pairs) {
        ++named[i + 1];
        ++named[j + 1];
    }
    std::partial_sum(named.begin(), named.end(), named.begin());
    std::vector<Index> all(named.back());
    std::vector<std::size_t> next(named.begin(), named.end() - 1);
    for (const auto& [i, j] : pairs) {
        all[next[i]++] = j;
        all[next[j]++] = i;
    }
    first.push_back(0);
    // For each vertex, the last v among whose neighbours it was counted: once for each v.
    std::vector<Index> last(vertices, -1);
    for (Index v = 0; v < vertices; ++v) {
        last[v] = v;
        for (std::size_t at = named[v]; at < named[v + 1]; ++at)
            if (std::exchange(last[all[at]], v) != v) neighbour.push_back(all[at]);
        first.push_back(neighbour.size());
    }
}

bool HessianPatch::build(const Potential& potential, const VertexGraph& graph, const Positions& x,
                         const Positions* elsewhere, const std::vector<char>& inside,
                         const Threads& threads) {
    const Shell& shell = potential.mechanics();
    std::vector<std::pair<Index, Index>> pairs = potential.contacts(x);
    if (elsewhere != nullptr) {
        const std::vector<std::pair<Index, Index>> there = potential.contacts(*elsewhere);
        pairs.insert(pairs.end(), there.begin(), there.end());
    }
    std::erase_if(pairs, [&](const auto& pair) { return !inside[pair.first] && !inside[pair.second]; });
    std::vector<char> near = inside;
    for (const auto& [i, j] : pairs) near[i] = near[j] = 1;
    for (Index v = 0; v < graph.size(); ++v)
        if (inside[v])
            for (const Index other : graph.around(v)) near[other] = 1;
    vertices.clear();
    inner.clear();
    std::vector<char> keep;
    for (Index v = 0; v < graph.size(); ++v) {
        if (!near[v]) continue;
        vertices.push_back(v);
        keep.push_back(inside[v]);
        if (inside[v]) inner.push_back(v);
        for (const Index other : graph.around(v))
            if (other < v && near[other]) pairs.emplace_back(v, other);
    }
    matrix = BlockMatrix::part(vertices, graph.size(), pairs, shell.fixed, shell.guide, shell.guides);
    solver = single_precision_solver(threads);
    for (const Curvature curvature : {Curvature::exact, Curvature::convex}) {
        set_hessian(potential, x, elsewhere, curvature, *matrix);
        const BlockMatrix own = matrix->restricted(keep);
        const Stopwatch watch(potential.time_spent(), Task::factorization);
        if (curvature == Curvature::exact) solver->analyze(own);
        if (solver->factorize(own)) return true;
    }
    clear();
    return false;
}

Positions HessianPatch::solve(const Positions& right_side) const {
    VectorXd own(3 * inner.size());
    for (std::size_t i = 0; i < inner.size(); ++i)
        own.segment<3>(static_cast<Eigen::Index>(3 * i)) = right_side.col(inner[i]);
    own = solver->solve(own);
    Positions motion = Positions::Zero(3, right_side.cols());
    for (std::size_t i = 0; i < inner.size(); ++i)
        motion.col(inner[i]) = own.segment<3>(static_cast<Eigen::Index>(3 * i));
    return motion;
}

Positions HessianPatch::residual(Positions right_side, const Positions& motion) const {
    const Positions product = matrix->times(motion(Eigen::all, vertices));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        right_side.col(vertices[i]) -= product.col(static_cast<Eigen::Index>(i));
    return right_side;
}

}  // namespace sherd
