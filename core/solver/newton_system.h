// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>

#include "core/solver/linear_solver.h"
#include "core/solver/potential.h"
#include "core/state_visitor.h"

namespace sherd {

/// No matrix of Newton's method, not even a convex one, is positive definite in its numbers.
struct IndefiniteMatrix : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The matrix of Newton's method and its factor. The pattern is kept as long as it contains all blocks of the
/// Hessian, also while contacts come and go, until most of those of contacts are unused.
class NewtonSystem {
  public:
    explicit NewtonSystem(std::unique_ptr<LinearSolver> solver) : solver(std::move(solver)) {}
    /// Keeps in mind which vertices were born: the pattern must be made anew before the next factorization.
    void follow(const ShellChange& change);
    /// Makes the pattern anew, for Hessians near x, after vertices were split or hinges removed.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Factors the Hessian at x. If it is not positive definite, it is blended with its convex approximation,
    /// which at last replaces it. The share that was enough last time is tried first. Missing blocks of contacts make the pattern anew. Throws IndefiniteMatrix
    /// when no matrix is positive definite.
    void factorize(const Potential& potential, const Positions& x);
    /// Solves with the last factor. right_side: [3, V].
    Positions solve(const Potential& potential, const Positions& right_side);
    const BlockMatrix& hessian() const { return *matrix; }  ///< that was factored last
    /// Iterations of a solution each that take as long as a factorization. forces: what an iteration takes
    /// beside the solution, in entries of a factor that take as long.
    double iterations_per_factorization(double hessian, double forces) const {
        const FactorCost cost = solver->cost();
        return (cost.factorization + hessian) / (cost.solution + forces);
    }
    /// The pattern, and what is remembered of earlier matrices; factors are made of each matrix anew.
    void visit_state(StateVisitor& visit);
    /// For factors that are to last: the matrix that was factored last, after visit_state().
    void visit_factor(StateVisitor& visit);

  private:
    void analyze(const Potential& potential, const Positions& x);
    /// Keeps the order of elimination, with the vertices born since; false if the factor would be much
    /// larger.
    bool keeps_order();
    /// Makes the pattern anew where blocks lack, or most of those of contacts are dead.
    void fit_pattern(const Potential& potential, const Positions& x);
    /// Factors the Hessian with this number of a share of the convex one. Returns whether that is definite.
    /// is_exact: the matrix is the exact Hessian at x.
    bool has_factor(const Potential& potential, const Positions& x, int share, bool is_exact);
    bool has_factor(const Potential& potential);

    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
    int share = 0;                  ///< number of the share of the convex matrix that did last
    int tried = 0, wait = 1;        ///< matrices since it changed, and after how many a lower one is tried
    std::vector<Index> parents;     ///< of the vertices born since the last analysis
    std::vector<Index> order;       ///< that was given for the last analysis; empty: none
    double cost_of_own = 0;         ///< of a factorization in the last order that was looked for
    std::size_t contact_pairs = 0;  ///< pairs of vertices that were in contact when the pattern was made
};

}  // namespace sherd
