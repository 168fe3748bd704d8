// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/threads.h"

namespace sherd {

// Operations on dense matrices, which are stored column by column, with `stride` numbers from one column to
// the next. Results have the same bits with any number of threads. Real: float or double.

template <class Real>
Real* column_of(Real* matrix, Index stride, Index column) {
    return matrix + static_cast<std::ptrdiff_t>(stride) * column;
}

template <class Real>
using ConstColumn = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, 1>>;

/// Cholesky factorization of the upper square [width, width] of a matrix [height, width], and below <- below
/// * L^-T for the rows below the square, with its factor L; both in place; only the lower triangle of the
/// square is used. Returns the number of eliminated columns: if it is less than `width`, the next column has
/// a pivot, still in its place, that is not positive and finite.
template <class Real>
Index eliminate_columns(Real* matrix, Index height, Index width, const Threads& threads);

/// Lower triangle of target [rows, rows] <- -panel * panel^T. panel: [rows, columns].
template <class Real>
void negative_square(const Real* panel, Index stride, Index rows, Index columns, Real* target,
                     const Threads& threads);

/// Forward substitution with the result of eliminate_columns(): own <- L^-1 * own, [width], and below <-
/// (rows below the square) * own, [height - width].
template <class Real>
void substitute_forward(const Real* matrix, Index height, Index width, Real* own, Real* below);

/// Back substitution: own <- L^-T * (own - (rows below the square)^T * below).
template <class Real>
void substitute_back(const Real* matrix, Index height, Index width, Real* own, const Real* below);

}  // namespace sherd
