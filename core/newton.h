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

/// The matrix of Newton's method and its factor; they are kept as long as the pattern is the same, or, as
/// contacts come and go, large enough.
struct NewtonSystem {
    BlockMatrix matrix;
    LinearSolver solver;

    NewtonSystem(const IncrementalPotential& potential, const Positions& x)
        : matrix(potential.hessian_pattern(x)) {
        const Stopwatch watch(potential.time_spent(), Task::analysis);
        solver.analyze(matrix);
    }
};

/// Minimises the potential from x [3, V] on, by Newton's method with backtracking. Takes the exact Hessian;
/// where that is not positive definite, a blend of it with its convex neighbour, or at last that one. x must
/// be where the potential is finite; no motion leads through a place where it is not.
NewtonResult minimise(const IncrementalPotential& potential, NewtonSystem& system,
                      const NewtonOptions& options, Positions& x);

}  // namespace sherd
