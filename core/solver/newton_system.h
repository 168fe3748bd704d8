// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>

#include "core/solver/linear/linear_solver.h"
#include "core/solver/potential.h"
#include "core/state_visitor.h"

namespace sherd {

/// Thrown when no matrix of Newton's method, not even the convex one, is numerically positive definite.
struct IndefiniteMatrix : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The matrix of Newton's method and its factor. While contacts begin and end, the pattern is kept as long as
/// it contains all blocks of the Hessian and enough of its blocks of contacts are in use.
class NewtonSystem {
  public:
    explicit NewtonSystem(std::unique_ptr<LinearSolver> solver) : solver(std::move(solver)) {}
    /// Records the parents of inserted vertices. The pattern must be rebuilt before the next factorization.
    void follow(const ShellChange& change);
    /// Rebuilds the pattern, for Hessians near x, after a change of the shell.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Factors the Hessian at x. As long as the matrix is not positive definite, the Hessian is blended with
    /// its convex approximation, with growing weights; in the last attempt the approximation replaces it. The
    /// first weight is the weight that sufficed last or, from time to time, the next lower one. The pattern
    /// is rebuilt if it lacks blocks of contacts. Throws IndefiniteMatrix when no matrix is positive
    /// definite.
    void factorize(const Potential& potential, const Positions& x);
    /// Solves with the last factor. right_side: [3, N].
    Positions solve(const Potential& potential, const Positions& right_side);
    const BlockMatrix& hessian() const { return *matrix; }  ///< the matrix factored last
    /// Number of iterations, with one solution each, that take as long as computing and factorizing a
    /// Hessian. hessian: time to compute a Hessian; forces: time of an iteration without its solution; both
    /// in the unit of FactorCost.
    double iterations_per_factorization(double hessian, double forces) const {
        const FactorCost cost = solver->cost();
        return (cost.factorization + hessian) / (cost.solution + forces);
    }
    /// Visits the pattern and the history of earlier matrices, but no factor.
    void visit_state(StateVisitor& visit);
    /// Visits the matrix factored last, after visit_state(), for minimisers that reuse a factor.
    void visit_factor(StateVisitor& visit);

  private:
    void analyze(const Potential& potential, const Positions& x);
    /// Analyzes the matrix in the last elimination order, extended by the vertices inserted since. Returns
    /// false if the order does not fit the matrix, or if a factorization would take much longer than in the
    /// order that the solver chose last. body_columns: see Potential.
    bool keeps_order(Index body_columns);
    /// Rebuilds the pattern if blocks of contacts at x are missing, or most blocks of contacts are unused.
    void fit_pattern(const Potential& potential, const Positions& x);
    /// Factors the blend of the exact Hessian and, with the weight shares_of_convex[share], the convex one.
    /// Returns whether the blend is positive definite. is_exact: whether `matrix` already is the exact
    /// Hessian at x.
    bool has_factor(const Potential& potential, const Positions& x, int share, bool is_exact);
    bool has_factor(const Potential& potential);

    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
    int share = 0;               ///< index of the weight of the convex Hessian that sufficed last
    int tried = 0, wait = 1;     ///< number of factorizations since `share` changed, and number after which a
                                 ///< lower share is tried
    std::vector<Index> parents;  ///< parents of the vertices inserted since the last analysis
    std::vector<Index> order;    ///< order given to the last analysis; empty: none
    double cost_of_own = 0;      ///< FactorCost::factorization in the last order that the solver chose
    std::size_t contact_pairs = 0;  ///< number of pairs of vertices in contact when the pattern was made
};

}  // namespace sherd
