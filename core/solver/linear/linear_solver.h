// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/block_matrix.h"
#include "core/threads.h"

namespace sherd {

/// Estimated time of a factorization and of a solution, in units of the time that a solution takes for one
/// entry of the factor.
struct FactorCost {
    double factorization = 0, solution = 0;
};

/// Direct solver for symmetric systems. Its results must be the same to the last bit for any number of
/// threads.
struct LinearSolver {
    virtual ~LinearSolver() = default;
    /// Prepares for matrices of this pattern. order: elimination order of the vertices, [V]; empty: the
    /// solver chooses one with a sparse factor. Throws std::runtime_error when out of memory.
    virtual void analyze(const BlockMatrix& matrix, const std::vector<Index>& order) = 0;
    void analyze(const BlockMatrix& matrix) { analyze(matrix, {}); }
    /// The elimination order of the last analysis, [V].
    virtual std::vector<Index> order() const = 0;
    /// Factors a matrix of the analyzed pattern. Returns false if the matrix is singular, or if the solver
    /// requires a positive definite matrix and this matrix is not.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Solves with the last factor. right_side: [size].
    virtual VectorXd solve(const VectorXd& right_side) = 0;
    /// Cost estimated from the analyzed pattern, without measured times.
    virtual FactorCost cost() const = 0;
};

/// Width of the indices by which CHOLMOD counts entries of a factor.
enum class Indices {
    as_needed,  ///< 32 bits, or 64 where the factor has more than 2^31 entries
    wide        ///< 64 bits
};

/// A solver with CHOLMOD's supernodal Cholesky factorization, in one thread: a second thread did not help at
/// the usual sizes. Matrices must be positive definite.
std::unique_ptr<LinearSolver> cholesky_solver(Indices indices = Indices::as_needed);

/// A solver in single precision, with half the memory and time of double precision, to which it changes for a
/// matrix that is too badly scaled. Matrices must be positive definite.
std::unique_ptr<LinearSolver> single_precision_solver(Threads threads = Threads());

/// A solver with CHOLMOD's simplicial L D L^T factorization, also of indefinite matrices. It does not pivot,
/// so that its solutions are only as accurate as the smallest pivot allows.
std::unique_ptr<LinearSolver> indefinite_solver();

}  // namespace sherd
