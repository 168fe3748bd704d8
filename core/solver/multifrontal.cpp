// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/multifrontal.h"

#include <cblas.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sherd {
namespace {

constexpr Index smallest_block = 16;  // columns, below which calls of BLAS take longer than they save

/// below <- below lower^-T. lower: [columns, columns]; below: [rows, columns].
void solve_right(const float* lower, float* below, Index stride, Index rows, Index columns) {
    cblas_strsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, rows, columns, 1, lower,
                stride, below, stride);
}
void solve_right(const double* lower, double* below, Index stride, Index rows, Index columns) {
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, rows, columns, 1, lower,
                stride, below, stride);
}
/// Subtracts panel panel^T from the lower triangle of `keep` times target. panel: [rows, columns].
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

template <class Real>
using Column = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, 1>>;
template <class Real>
using ConstColumn = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, 1>>;
template <class Real>
using Part = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>, 0, Eigen::OuterStride<>>;

template <class Real>
Real* column_of(Real* matrix, Index stride, Index column) {
    return matrix + static_cast<std::ptrdiff_t>(stride) * column;
}

/// Eliminates the columns of [height, width] in place, one after the other.
template <class Real>
bool eliminate_columns(Real* front, Index stride, Index height, Index width) {
    for (Index j = 0; j < width; ++j) {
        Real* const column = column_of(front, stride, j);
        if (!(column[j] > std::numeric_limits<Real>::min()) || !std::isfinite(column[j])) return false;
        Column<Real>(column + j, height - j) *= 1 / std::sqrt(column[j]);
        for (Index k = j + 1; k < width; ++k)
            Column<Real>(column_of(front, stride, k) + k, height - k) -=
                column[k] * ConstColumn<Real>(column + k, height - k);
    }
    return true;
}

/// Cholesky factorization of [width, width] in place, by halves.
template <class Real>
bool eliminate_square(Real* square, Index stride, Index width) {
    if (width <= smallest_block) return eliminate_columns(square, stride, width, width);
    const Index half = width / 2;
    if (!eliminate_square(square, stride, half)) return false;
    solve_right(square, square + half, stride, width - half, half);
    Real* const rest = column_of(square, stride, half) + half;
    subtract_square(square + half, stride, width - half, half, Real(1), rest, stride);
    return eliminate_square(rest, stride, width - half);
}

}  // namespace

template <class Real>
MultifrontalFactor<Real>::MultifrontalFactor(std::shared_ptr<const Supernodes> of)
    : pattern(std::move(of)), children(pattern->size()), local(pattern->place.size()) {
    start.push_back(0);
    for (Index node = 0; node < pattern->size(); ++node) {
        start.push_back(start.back() + static_cast<std::size_t>(height(node)) * width(node));
        if (pattern->parent[node] >= 0) children[pattern->parent[node]].push_back(node);
    }
    values.resize(start.back());
    std::size_t top = 0, highest = 0;
    for (Index node = 0; node < pattern->size(); ++node) {
        highest = std::max(highest, top + update_size(node));
        for (const Index child : children[node]) top -= update_size(child);
        top += update_size(node);
    }
    updates.resize(highest);
}

template <class Real>
void MultifrontalFactor<Real>::scatter(const BlockMatrix& matrix) {
    std::fill(values.begin(), values.end(), Real(0));
    for (Index j = 0; j < matrix.size() / 3; ++j) {
        const Index own = pattern->place[j], node = pattern->of_column[own];
        const Index diagonal = own - pattern->first[node];
        for (Index c = 0; c < 3; ++c) {
            const double* value = matrix.values().data() + matrix.columns()[3 * j + c];
            Real* const target = column_of(panel(node), height(node), 3 * diagonal + c) + 3 * diagonal;
            for (Index r = c; r < 3; ++r) target[r] = static_cast<Real>(*value++);
            for (Index b = matrix.block_columns()[j]; b < matrix.block_columns()[j + 1]; ++b, value += 3) {
                const Index other = pattern->place[matrix.block_rows()[b]], below = pattern->block_place[b];
                const Index left = std::min(own, other), of = pattern->of_column[left];
                const Index column = 3 * (left - pattern->first[of]), rows = height(of);
                for (Index r = 0; r < 3; ++r) {
                    const auto [down, right] = own < other ? std::pair(r, c) : std::pair(c, r);
                    column_of(panel(of), rows, column + right)[3 * below + down] =
                        static_cast<Real>(value[r]);
                }
            }
        }
    }
}

template <class Real>
void MultifrontalFactor<Real>::extend(Index child, const Real* of_child, Index node, Columns columns,
                                      Real* target) {
    const std::span<const Index> rows = pattern->rows_below(child);
    const Index size = static_cast<Index>(rows.size()), own = pattern->columns(node);
    const Index split = static_cast<Index>(
        std::ranges::find_if(rows, [&](Index row) { return local[row] >= own; }) - rows.begin());
    const bool below = columns == Columns::below;
    const Index first = below ? own : 0, stride = below ? height(node) - width(node) : height(node);
    for (Index b = below ? split : 0; b < (below ? size : split); ++b)
        for (Index c = 0; c < 3; ++c) {
            const Real* const from = of_child + static_cast<std::ptrdiff_t>(3 * size) * (3 * b + c);
            Real* const to = column_of(target, stride, 3 * (local[rows[b]] - first) + c) - 3 * first;
            for (Index a = b; a < size; ++a) {
                Real* const at = to + 3 * local[rows[a]];
                for (Index r = 0; r < 3; ++r) at[r] += from[3 * a + r];
            }
        }
}

template <class Real>
bool MultifrontalFactor<Real>::eliminate(Index node) {
    const Index rows = height(node), columns = width(node), below = rows - columns;
    Real* const front = panel(node);
    if (!eliminate_square(front, rows, columns)) return false;
    if (below > 0) solve_right(front, front + columns, rows, below, columns);
    return true;
}

template <class Real>
std::size_t MultifrontalFactor<Real>::update_size(Index node) const {
    const auto below = static_cast<std::size_t>(height(node) - width(node));
    return below * below;
}

template <class Real>
bool MultifrontalFactor<Real>::factorize(const BlockMatrix& matrix) {
    scatter(matrix);
    std::size_t top = 0;  // of the stack
    for (Index node = 0; node < pattern->size(); ++node) {
        const std::span<const Index> rows = pattern->rows(node);
        for (std::size_t at = 0; at < rows.size(); ++at) local[rows[at]] = static_cast<Index>(at);
        std::size_t bottom = top;
        for (const Index child : children[node]) bottom -= update_size(child);
        const auto each_child = [&](Columns columns, Real* target) {
            const Real* of_child = updates.data() + bottom;
            for (const Index child : children[node]) {
                extend(child, of_child, node, columns, target);
                of_child += update_size(child);
            }
        };
        each_child(Columns::own, panel(node));
        if (!eliminate(node)) return false;
        const Index below = height(node) - width(node);
        Real* const update = updates.data() + top;
        if (below > 0) {
            subtract_square(panel(node) + width(node), height(node), below, width(node), Real(0), update,
                            below);
            each_child(Columns::below, update);
        }
        std::copy_n(update, update_size(node), updates.data() + bottom);
        top = bottom + update_size(node);
    }
    return true;
}

template <class Real>
VectorXd MultifrontalFactor<Real>::solve(const VectorXd& right_side) const {
    const auto vertices = static_cast<Index>(pattern->place.size());
    const double scale = right_side.size() > 0 ? right_side.cwiseAbs().maxCoeff() : 0;
    if (!(scale > 0)) return VectorXd::Zero(right_side.size());
    Eigen::Matrix<Real, Eigen::Dynamic, 1> y(right_side.size()), below(right_side.size());
    for (Index v = 0; v < vertices; ++v)
        y.template segment<3>(3 * pattern->place[v]) =
            (right_side.segment<3>(3 * v) / scale).template cast<Real>();
    for (Index node = 0; node < pattern->size(); ++node) {
        const Index rows = height(node), columns = width(node), rest = rows - columns;
        const Real* const front = panel(node);
        auto own = y.segment(3 * pattern->first[node], columns);
        for (Index j = 0; j < columns; ++j) {
            const Real* const column = column_of(front, rows, j);
            own[j] /= column[j];
            own.tail(columns - j - 1) -= own[j] * ConstColumn<Real>(column + j + 1, columns - j - 1);
        }
        auto part = below.head(rest);
        part.noalias() = Part<Real>(front + columns, rest, columns, Eigen::OuterStride<>(rows)) * own;
        const std::span<const Index> at = pattern->rows_below(node);
        for (std::size_t a = 0; a < at.size(); ++a)
            y.template segment<3>(3 * at[a]) -= part.template segment<3>(static_cast<Index>(3 * a));
    }
    for (Index node = pattern->size() - 1; node >= 0; --node) {
        const Index rows = height(node), columns = width(node), rest = rows - columns;
        const Real* const front = panel(node);
        const std::span<const Index> at = pattern->rows_below(node);
        for (std::size_t a = 0; a < at.size(); ++a)
            below.template segment<3>(static_cast<Index>(3 * a)) = y.template segment<3>(3 * at[a]);
        auto own = y.segment(3 * pattern->first[node], columns);
        own.noalias() -= Part<Real>(front + columns, rest, columns, Eigen::OuterStride<>(rows)).transpose() *
                         below.head(rest);
        for (Index j = columns - 1; j >= 0; --j) {
            const Real* const column = column_of(front, rows, j);
            own[j] -= ConstColumn<Real>(column + j + 1, columns - j - 1).dot(own.tail(columns - j - 1));
            own[j] /= column[j];
        }
    }
    VectorXd x(right_side.size());
    for (Index v = 0; v < vertices; ++v)
        x.segment<3>(3 * v) = scale * y.template segment<3>(3 * pattern->place[v]).template cast<double>();
    return x;
}

template class MultifrontalFactor<float>;
template class MultifrontalFactor<double>;

}  // namespace sherd
