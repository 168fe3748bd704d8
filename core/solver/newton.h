// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/solver/linear_solver.h"
#include "core/solver/minimiser.h"
#include "core/state_visitor.h"

namespace sherd {

/// The matrix of Newton's method and its factor. The pattern is kept as long as it contains all blocks of the
/// Hessian, also while contacts come and go.
class NewtonSystem {
  public:
    explicit NewtonSystem(std::unique_ptr<LinearSolver> solver) : solver(std::move(solver)) {}
    /// Makes the pattern anew, for Hessians near x, after vertices were split or hinges removed.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Factors the Hessian at x. If it is not positive definite, it is blended with its convex approximation,
    /// which at last replaces it. Missing blocks of contacts make the pattern anew. Throws std::runtime_error
    /// when no matrix is positive definite.
    void factorize(const Potential& potential, const Positions& x);
    /// Solves with the last factor. right_side: [3, V].
    Positions solve(const Potential& potential, const Positions& right_side);
    /// The pattern; factors are made of each matrix anew.
    void visit_state(StateVisitor& visit);

  private:
    void analyze(const Potential& potential, const Positions& x);
    /// Factors `matrix`. Returns whether it is positive definite.
    bool has_factor(const Potential& potential);

    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
};

/// Newton's method with a backtracking line search.
class Newton : public Minimiser {
  public:
    /// tolerance: m; the method has converged when the largest coordinate of a correction is below it.
    explicit Newton(double tolerance = 1e-9, std::unique_ptr<LinearSolver> solver = cholesky_solver())
        : tolerance(tolerance), system(std::move(solver)) {}
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x) override;
    MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) override;
    void visit_state(StateVisitor& visit) override {
        auto& [tolerance, system] = *this;
        visit(system);
    }

  private:
    double tolerance;
    NewtonSystem system;
};

}  // namespace sherd
