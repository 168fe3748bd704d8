// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/solver/linear_solver.h"
#include "core/solver/minimiser.h"

namespace sherd {

/// The matrix of Newton's method and its factor, kept as long as the pattern is the same, or, as contacts
/// come and go, large enough.
class NewtonSystem {
  public:
    explicit NewtonSystem(std::unique_ptr<LinearSolver> solver) : solver(std::move(solver)) {}
    /// Vertices were split or hinges removed: makes the pattern anew, for Hessians near x.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Factors the Hessian at x; where that is not positive definite, a blend of it with its convex
    /// neighbour, or at last that one. Blocks of contacts that the pattern lacks make it anew. Throws
    /// std::runtime_error when none is positive definite.
    void factorize(const Potential& potential, const Positions& x);
    /// Solves with the last factor. right_side: [3, V].
    Positions solve(const Potential& potential, const Positions& right_side);

  private:
    void analyze(const Potential& potential, const Positions& x);
    /// Factors `matrix`; whether it is positive definite.
    bool has_factor(const Potential& potential);

    std::optional<BlockMatrix> matrix;
    std::unique_ptr<LinearSolver> solver;
};

/// Newton's method with backtracking.
class Newton : public Minimiser {
  public:
    /// tolerance: m, that the largest coordinate of the last correction may have.
    explicit Newton(double tolerance = 1e-9, std::unique_ptr<LinearSolver> solver = cholesky_solver())
        : tolerance(tolerance), system(std::move(solver)) {}
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x) override;
    MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) override;

  private:
    double tolerance;
    NewtonSystem system;
};

}  // namespace sherd
