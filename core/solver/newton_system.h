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

/// The matrix of Newton's method and its factor. The pattern is kept as long as it contains all blocks of the
/// Hessian, also while contacts come and go, until most blocks of contacts are unused.
class NewtonSystem {
  public:
    explicit NewtonSystem(std::unique_ptr<LinearSolver> solver) : solver(std::move(solver)) {}
    /// Records the parents of inserted vertices. The pattern must be rebuilt before the next factorization.
    void follow(const ShellChange& change);
    /// Rebuilds the pattern, for Hessians near x, after a change of the shell.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Factors the Hessian at x. If it is not positive definite, it is blended with its convex approximation,
    /// which replaces it in the last attempt. The weight that sufficed last is tried first. The pattern is
    /// rebuilt if it lacks blocks of contacts. Throws IndefiniteMatrix when no matrix is positive definite.
    void factorize(const Potential& potential, const Positions& x);
    /// Solves with the last factor. right_side: [3, V].
    Positions solve(const Potential& potential, const Positions& right_side);
    const BlockMatrix& hessian() const { return *matrix; }  ///< the matrix factored last
    /// Number of iterations with one solution each that take as long as a Hessian with its factorization.
    /// hessian, forces: time of a Hessian, and of an iteration besides its solution, in the unit of
    /// FactorCost.
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
    /// Keeps the elimination order, with the vertices inserted since. Returns false if a factorization would
    /// take much longer. body_columns: see Potential.
    bool keeps_order(Index body_columns);
    /// Rebuilds the pattern if blocks are missing, or most blocks of contacts are unused.
    void fit_pattern(const Potential& potential, const Positions& x);
    /// Factors the Hessian with the weight shares_of_convex[share] of the convex one. Returns whether the
    /// matrix is positive definite. is_exact: whether `matrix` is the exact Hessian at x.
    bool has_factor(const Potential& potential, const Positions& x, int share, bool is_exact);
    bool has_factor(const Potential& potential);

    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
    int share = 0;               ///< index of the weight of the convex Hessian that sufficed last
    int tried = 0, wait = 1;     ///< matrices since it changed, and number after which a lower one is tried
    std::vector<Index> parents;  ///< parents of the vertices inserted since the last analysis
    std::vector<Index> order;    ///< order given to the last analysis; empty: none
    double cost_of_own = 0;      ///< cost of a factorization in the last order that the solver chose
    std::size_t contact_pairs = 0;  ///< pairs of vertices in contact when the pattern was made
};

}  // namespace sherd
