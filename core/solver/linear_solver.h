// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/block_matrix.h"

namespace sherd {

/// Direct solver for symmetric positive definite systems. Its results must be the same to the last bit for
/// any number of threads.
struct LinearSolver {
    virtual ~LinearSolver() = default;
    /// Prepares for matrices of this pattern. Throws std::runtime_error when out of memory.
    virtual void analyze(const BlockMatrix& matrix) = 0;
    /// Factors a matrix of the analyzed pattern. Returns false when it is not positive definite.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Solves with the last factor. right_side: [size].
    virtual VectorXd solve(const VectorXd& right_side) = 0;
};

/// A solver with CHOLMOD's supernodal Cholesky factorization, in one thread: a second one never helped at
/// these sizes.
std::unique_ptr<LinearSolver> cholesky_solver();

}  // namespace sherd
