// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/block_matrix.h"

namespace sherd {

/// Direct solver for symmetric positive definite systems: CHOLMOD's supernodal Cholesky factorization.
/// Runs in one thread: two never helped at these sizes, and the result's bits must not depend on their
/// number.
class LinearSolver {
  public:
    LinearSolver();
    ~LinearSolver();
    LinearSolver(LinearSolver&&) noexcept;
    LinearSolver& operator=(LinearSolver&&) noexcept;

    /// Chooses the ordering and the structure of the factor from the matrix's pattern. Throws
    /// std::runtime_error when out of memory.
    void analyze(const BlockMatrix& matrix);
    /// Factors a matrix of the analyzed pattern. Returns false when it is not positive definite.
    bool factorize(const BlockMatrix& matrix);
    /// Solves with the last factor. right_side: [size].
    VectorXd solve(const VectorXd& right_side);

  private:
    struct State;
    std::unique_ptr<State> state;
};

}  // namespace sherd
