// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/solver/linear/linear_solver.h"
#include "core/solver/potential.h"
#include "core/vector.h"

namespace sherd {

/// The neighbours of each vertex: the other vertices with which it has a block in the Hessian.
class VertexGraph {
  public:
    VertexGraph() = default;
    /// pairs: vertices with a common block, in any order; a pair may be repeated.
    VertexGraph(Index vertices, const std::vector<std::pair<Index, Index>>& pairs);
    std::span<const Index> around(Index vertex) const {
        return {neighbour.data() + first[vertex], first[vertex + 1] - first[vertex]};
    }
    Index size() const { return first.empty() ? 0 : static_cast<Index>(first.size()) - 1; }

  private:
    std::vector<std::size_t> first;
    std::vector<Index> neighbour;
};

/// Part of a shell whose equations are solved with the present Hessian while the vertices around it are held.
class HessianPatch {
  public:
    /// Factorizes the rows and columns of the Hessian at x that belong to the vertices with a flag `inside`,
    /// [V]. If `elsewhere` is not null, the contribution of contact is the mean of the contributions at x and
    /// at `elsewhere`. graph: neighbours by all blocks except blocks of contacts. Returns false if neither
    /// the exact nor the convex matrix of the part is positive definite.
    bool build(const Potential& potential, const VertexGraph& graph, const Positions& x,
               const Positions* elsewhere, const std::vector<char>& inside, const Threads& threads);
    void clear() { matrix.reset(); }
    bool empty() const { return !matrix; }
    /// Displacement, m, [3, V], with which the forces `right_side`, N, [3, V], vanish inside; zero outside.
    Positions solve(const Positions& right_side) const;
    /// Returns right_side - Hessian * motion: correct for the vertices inside, and for all vertices if the
    /// motion is zero outside.
    Positions residual(Positions right_side, const Positions& motion) const;

  private:
    std::vector<Index> vertices;  ///< vertices inside, and their neighbours, ascending
    std::vector<Index> inner;     ///< vertices inside, ascending
    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
};

}  // namespace sherd
