// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/threads.h"

namespace sherd {

// Dense matrices of a factorization, column by column, with `stride` from one column to the next. They have
// the same bits with any number of threads. Real: float or double.

template <class Real>
Real* column_of(Real* matrix, Index stride, Index column) {
    return matrix + static_cast<std::ptrdiff_t>(stride) * column;
}

template <class Real>
using ConstColumn = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, 1>>;

/// Cholesky factorization of the upper square [width, width] of a matrix [height, width], and below <- below
/// square^-T for the rows below it, in place; only the lower triangle of the square is used. Returns the
/// number of eliminated columns: if not all, the next one has a pivot, still in its place, that is not
/// positive.
template <class Real>
Index eliminate_columns(Real* matrix, Index height, Index width, const Threads& threads);

/// Lower triangle of target [rows, rows] <- -panel panel^T. panel: [rows, columns].
template <class Real>
void negative_square(const Real* panel, Index stride, Index rows, Index columns, Real* target,
                     const Threads& threads);

/// Forward substitution with the result of eliminate_columns(): own <- square^-1 own, [width], and below <-
/// the rows below times own, [height - width].
template <class Real>
void substitute_forward(const Real* matrix, Index height, Index width, Real* own, Real* below);

/// Back substitution: own <- square^-T (own - the rows below, transposed, times below).
template <class Real>
void substitute_back(const Real* matrix, Index height, Index width, Real* own, const Real* below);

}  // namespace sherd
