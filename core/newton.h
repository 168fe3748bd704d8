// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incremental_potential.h"
#include "core/linear_solver.h"

namespace sherd {

struct NewtonOptions {
    int max_iterations = 50;
    double tolerance = 1e-9;  ///< m, largest coordinate of the last correction
};

struct NewtonResult {
    int iterations = 0;
    bool converged = false;
    double correction = 0;  ///< m, largest coordinate of the last correction
};

/// The matrix of Newton's method and its factor; they are kept as long as the pattern is the same.
struct NewtonSystem {
    BlockMatrix matrix;
    LinearSolver solver;

    explicit NewtonSystem(const IncrementalPotential& potential) : matrix(potential.hessian_pattern()) {
        solver.analyze(matrix);
    }
};

/// Minimises the potential from x [3, V] on, by Newton's method with backtracking. Takes the exact Hessian,
/// and its convex neighbour where that is not positive definite.
NewtonResult minimise(const IncrementalPotential& potential, NewtonSystem& system,
                      const NewtonOptions& options, Positions& x);

}  // namespace sherd
