// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/dense_elimination.h"

#include <cblas.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

/// Number of columns below which calls of BLAS take longer than they save.
constexpr Index smallest_block = 16;
constexpr Index strip = 96;  // number of rows or columns that a thread takes at a time

/// below <- below * lower^-T. lower: [columns, columns]; below: [rows, columns].
void solve_right(const float* lower, float* below, Index stride, Index rows, Index columns) {
    cblas_strsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, rows, columns, 1, lower,
                stride, below, stride);
}
void solve_right(const double* lower, double* below, Index stride, Index rows, Index columns) {
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, rows, columns, 1, lower,
                stride, below, stride);
}
/// Lower triangle of target <- keep * target - panel * panel^T. panel: [rows, columns].
void subtract_square(const float* panel, Index stride, Index rows, Index columns, float keep, float* target,
                     Index stride_of_target) {
    cblas_ssyrk(CblasColMajor, CblasLower, CblasNoTrans, rows, columns, -1, panel, stride, keep, target,
                stride_of_target);
}
void subtract_square(const double* panel, Index stride, Index rows, Index columns, double keep,
                     double* target, Index stride_of_target) {
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, rows, columns, -1, panel, stride, keep, target,
                stride_of_target);
}
/// target <- keep * target - lower * upper^T. target: [rows, wide]; lower: [rows, columns]; upper: [wide,
/// columns].
void subtract_product(const float* lower, const float* upper, Index stride, Index rows, Index wide,
                      Index columns, float keep, float* target, Index stride_of_target) {
    cblas_sgemm(CblasColMajor, CblasNoTrans, CblasTrans, rows, wide, columns, -1, lower, stride, upper,
                stride, keep, target, stride_of_target);
}
void subtract_product(const double* lower, const double* upper, Index stride, Index rows, Index wide,
                      Index columns, double keep, double* target, Index stride_of_target) {
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, rows, wide, columns, -1, lower, stride, upper,
                stride, keep, target, stride_of_target);
}

void solve_triangle(CBLAS_TRANSPOSE how, const float* lower, Index stride, Index width, float* x) {
    cblas_strsv(CblasColMajor, CblasLower, how, CblasNonUnit, width, lower, stride, x, 1);
}
void solve_triangle(CBLAS_TRANSPOSE how, const double* lower, Index stride, Index width, double* x) {
    cblas_dtrsv(CblasColMajor, CblasLower, how, CblasNonUnit, width, lower, stride, x, 1);
}
/// target <- keep * target + share * matrix * x, or with the transpose of the matrix, as `how` says. matrix:
/// [rows, columns].
void multiply(CBLAS_TRANSPOSE how, float share, const float* matrix, Index stride, Index rows, Index columns,
              const float* x, float keep, float* target) {
    cblas_sgemv(CblasColMajor, how, rows, columns, share, matrix, stride, x, 1, keep, target, 1);
}
void multiply(CBLAS_TRANSPOSE how, double share, const double* matrix, Index stride, Index rows,
              Index columns, const double* x, double keep, double* target) {
    cblas_dgemv(CblasColMajor, how, rows, columns, share, matrix, stride, x, 1, keep, target, 1);
}

template <class Real>
using Column = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, 1>>;

/// Calls solve_right() for strips of rows, which threads share.
template <class Real>
void solve_strips(const Real* lower, Real* below, Index stride, Index rows, Index columns,
                  const Threads& threads) {
    threads.share_ranges(rows, strip, [&](Index begin, Index end) {
        solve_right(lower, below + begin, stride, end - begin, columns);
    });
}

/// Does the work of subtract_square() in strips of columns, which threads share.
template <class Real>
void subtract_strips(const Real* panel, Index stride, Index rows, Index columns, Real keep, Real* target,
                     Index stride_of_target, const Threads& threads) {
    threads.share_ranges(rows, strip, [&](Index begin, Index end) {
        Real* const diagonal = column_of(target, stride_of_target, begin) + begin;
        const Index wide = end - begin;
        subtract_square(panel + begin, stride, wide, columns, keep, diagonal, stride_of_target);
        if (end < rows)
            subtract_product(panel + end, panel + begin, stride, rows - end, wide, columns, keep,
                             diagonal + wide, stride_of_target);
    });
}

/// Cholesky factorization of `square`, [width, width], in place, column by column. Returns the number of
/// eliminated columns, see eliminate_columns().
template <class Real>
Index eliminate_one_by_one(Real* square, Index stride, Index width) {
    for (Index j = 0; j < width; ++j) {
        Real* const column = column_of(square, stride, j);
        if (!(column[j] > std::numeric_limits<Real>::min()) || !std::isfinite(column[j])) return j;
        Column<Real>(column + j, width - j) *= 1 / std::sqrt(column[j]);
        for (Index k = j + 1; k < width; ++k)
            Column<Real>(column_of(square, stride, k) + k, width - k) -=
                column[k] * ConstColumn<Real>(column + k, width - k);
    }
    return width;
}

/// Cholesky factorization of `square`, [width, width], in place, half by half. Returns the number of
/// eliminated columns, see eliminate_columns().
template <class Real>
Index eliminate_square(Real* square, Index stride, Index width, const Threads& threads) {
    if (width <= smallest_block) return eliminate_one_by_one(square, stride, width);
    const Index half = width / 2;
    if (const Index count = eliminate_square(square, stride, half, threads); count < half) return count;
    solve_strips(square, square + half, stride, width - half, half, threads);
    Real* const rest = column_of(square, stride, half) + half;
    subtract_strips(square + half, stride, width - half, half, Real(1), rest, stride, threads);
    return half + eliminate_square(rest, stride, width - half, threads);
}

}  // namespace

template <class Real>
Index eliminate_columns(Real* matrix, Index height, Index width, const Threads& threads) {
    const Index count = eliminate_square(matrix, height, width, threads);
    if (count == width && height > width)
        solve_strips(matrix, matrix + width, height, height - width, width, threads);
    return count;
}

template <class Real>
void negative_square(const Real* panel, Index stride, Index rows, Index columns, Real* target,
                     const Threads& threads) {
    if (rows > 0) subtract_strips(panel, stride, rows, columns, Real(0), target, rows, threads);
}

template <class Real>
void substitute_forward(const Real* matrix, Index height, Index width, Real* own, Real* below) {
    solve_triangle(CblasNoTrans, matrix, height, width, own);
    if (height > width)
        multiply(CblasNoTrans, Real(1), matrix + width, height, height - width, width, own, Real(0), below);
}

template <class Real>
void substitute_back(const Real* matrix, Index height, Index width, Real* own, const Real* below) {
    if (height > width)
        multiply(CblasTrans, Real(-1), matrix + width, height, height - width, width, below, Real(1), own);
    solve_triangle(CblasTrans, matrix, height, width, own);
}

template Index eliminate_columns(float*, Index, Index, const Threads&);
template Index eliminate_columns(double*, Index, Index, const Threads&);
template void negative_square(const float*, Index, Index, Index, float*, const Threads&);
template void negative_square(const double*, Index, Index, Index, double*, const Threads&);
template void substitute_forward(const float*, Index, Index, float*, float*);
template void substitute_forward(const double*, Index, Index, double*, double*);
template void substitute_back(const float*, Index, Index, float*, const float*);
template void substitute_back(const double*, Index, Index, double*, const double*);

}  // namespace sherd
