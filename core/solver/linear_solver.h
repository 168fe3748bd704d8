// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/block_matrix.h"

namespace sherd {

/// Direct solver for symmetric positive definite systems. The bits of its results must not depend on the
/// number of threads.
struct LinearSolver {
    virtual ~LinearSolver() = default;
    /// Makes ready for matrices of this pattern. Throws std::runtime_error when out of memory.
    virtual void analyze(const BlockMatrix& matrix) = 0;
    /// Factors a matrix of the analyzed pattern. Returns false when it is not positive definite.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Solves with the last factor. right_side: [size].
    virtual VectorXd solve(const VectorXd& right_side) = 0;
};

/// CHOLMOD's supernodal Cholesky factorization, in one thread: two never helped at these sizes.
std::unique_ptr<LinearSolver> cholesky_solver();

}  // namespace sherd
