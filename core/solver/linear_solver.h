// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/block_matrix.h"

namespace sherd {

/// Direct solver for symmetric systems. Its results must be the same to the last bit for any number of
/// threads.
struct LinearSolver {
    virtual ~LinearSolver() = default;
    /// Prepares for matrices of this pattern. Throws std::runtime_error when out of memory.
    virtual void analyze(const BlockMatrix& matrix) = 0;
    /// Factors a matrix of the analyzed pattern. Returns false when the solver cannot: it is singular, or the
    /// solver wants it positive definite and it is not.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Solves with the last factor. right_side: [size].
    virtual VectorXd solve(const VectorXd& right_side) = 0;
};

/// A solver with CHOLMOD's supernodal Cholesky factorization, in one thread: a second one never helped at
/// these sizes. It wants positive definite matrices.
std::unique_ptr<LinearSolver> cholesky_solver();

/// A solver with CHOLMOD's simplicial L D L^T factorization, also of indefinite matrices. It does not pivot,
/// so that its solutions are only as accurate as the smallest pivot allows.
std::unique_ptr<LinearSolver> indefinite_solver();

}  // namespace sherd
