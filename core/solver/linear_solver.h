// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/block_matrix.h"
#include "core/threads.h"

namespace sherd {

/// About what a factorization and a solution take, in the time that a solution takes for an entry of the
/// factor.
struct FactorCost {
    double factorization = 0, solution = 0;
};

/// Direct solver for symmetric systems. Its results must be the same to the last bit for any number of
/// threads.
struct LinearSolver {
    virtual ~LinearSolver() = default;
    /// Prepares for matrices of this pattern. order: in which the vertices are eliminated, [V]; empty: one is
    /// looked for in which the factor stays sparse. Throws std::runtime_error when out of memory.
    virtual void analyze(const BlockMatrix& matrix, const std::vector<Index>& order) = 0;
    void analyze(const BlockMatrix& matrix) { analyze(matrix, {}); }
    /// The order of the last analysis, [V].
    virtual std::vector<Index> order() const = 0;
    /// Factors a matrix of the analyzed pattern. Returns false when the solver cannot: it is singular, or the
    /// solver wants it positive definite and it is not.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Solves with the last factor. right_side: [size].
    virtual VectorXd solve(const VectorXd& right_side) = 0;
    /// By the analyzed pattern, so that it is the same at any time.
    virtual FactorCost cost() const = 0;
};

/// What CHOLMOD counts entries of a factor with.
enum class Indices {
    as_needed,  ///< 32 bits, or 64 where the factor has more than 2^31 entries
    wide        ///< 64 bits
};

/// A solver with CHOLMOD's supernodal Cholesky factorization, in one thread: a second one never helped at
/// these sizes. It wants positive definite matrices.
std::unique_ptr<LinearSolver> cholesky_solver(Indices indices = Indices::as_needed);

/// A solver in single precision, with half the memory and time, or in double precision where a matrix is too
/// badly scaled for that. It wants positive definite matrices.
std::unique_ptr<LinearSolver> single_precision_solver(Threads threads = Threads());

/// A solver with CHOLMOD's simplicial L D L^T factorization, also of indefinite matrices. It does not pivot,
/// so that its solutions are only as accurate as the smallest pivot allows.
std::unique_ptr<LinearSolver> indefinite_solver();

}  // namespace sherd
