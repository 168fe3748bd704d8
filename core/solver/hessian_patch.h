// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/solver/linear_solver.h"
#include "core/solver/potential.h"
#include "core/solver/vertex_graph.h"

namespace sherd {

/// Part of a shell whose own equations are solved with the Hessian as it is, the vertices around it held.
class HessianPatch {
  public:
    /// The Hessian is that at x, its part of contact perhaps the mean of x and another place. graph: of all
    /// blocks but those of contacts. inside: [V] flags. Returns false if the part's matrix, even the convex
    /// one, is not positive definite.
    bool build(const Potential& potential, const VertexGraph& graph, const Positions& x,
               const Positions* elsewhere, const std::vector<char>& inside, const Threads& threads);
    void clear() { matrix.reset(); }
    bool empty() const { return !matrix; }
    /// The motion inside, m, with which the forces there vanish; zero elsewhere. right_side: N, [3, V].
    Positions solve(const Positions& right_side) const;
    /// right_side less the Hessian times a motion: of the vertices inside, and for motions that are zero
    /// elsewhere of all.
    Positions residual(Positions right_side, const Positions& motion) const;

  private:
    std::vector<Index> vertices;  ///< inside and next to it, ascending
    std::vector<Index> inner;     ///< those inside, ascending
    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
};

}  // namespace sherd
