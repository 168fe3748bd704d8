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

/// Neighbours of each vertex: the others with which it has a block.
class VertexGraph {
  public:
    VertexGraph() = default;
    /// pairs: in any order, repeated or not.
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
    /// Factorizes the Hessian at x inside; with positions `elsewhere` (null: none), the contact part is the
    /// mean of both. graph: of all blocks but those of contacts. inside: [V] flags. Returns false if the
    /// part's matrix, even the convex one, is not positive definite.
    bool build(const Potential& potential, const VertexGraph& graph, const Positions& x,
               const Positions* elsewhere, const std::vector<char>& inside, const Threads& threads);
    void clear() { matrix.reset(); }
    bool empty() const { return !matrix; }
    /// Displacement inside, m, with which the forces there vanish; zero elsewhere. right_side: N, [3, V].
    Positions solve(const Positions& right_side) const;
    /// right_side less the Hessian times a motion: correct for the vertices inside, and for all vertices if
    /// the motion is zero elsewhere.
    Positions residual(Positions right_side, const Positions& motion) const;

  private:
    std::vector<Index> vertices;  ///< vertices inside and next to it, ascending
    std::vector<Index> inner;     ///< vertices inside, ascending
    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
};

}  // namespace sherd
