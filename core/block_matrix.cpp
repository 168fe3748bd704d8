// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/block_matrix.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sherd {

BlockMatrix::BlockMatrix(Index vertices, const std::vector<std::pair<Index, Index>>& pairs,
                         std::vector<char> fixed, std::vector<char> guide, std::vector<Matrix3d> guides)
    : fixed(std::move(fixed)), guide(std::move(guide)), guides(std::move(guides)) {
    this->fixed.resize(vertices, 0);
    if (!this->guide.empty()) this->guide.resize(vertices, 0);
    find_blocks(vertices, pairs);
    column_start.reserve(3 * static_cast<std::size_t>(vertices) + 1);
    row.reserve(6 * static_cast<std::size_t>(vertices) + 9 * block_row.size());
    column_start.push_back(0);
    for (Index j = 0; j < vertices; ++j) {
        for (Index c = 0; c < 3; ++c) {
            for (Index r = c; r < 3; ++r) row.push_back(3 * j + r);
            for (Index b = block_start[j]; b < block_start[j + 1]; ++b)
                for (Index r = 0; r < 3; ++r) row.push_back(3 * block_row[b] + r);
            column_start.push_back(static_cast<Index>(row.size()));
        }
    }
    value.resize(row.size());
    set_zero();
}

BlockMatrix BlockMatrix::part(std::span<const Index> some, Index vertices,
                              const std::vector<std::pair<Index, Index>>& pairs,
                              const std::vector<char>& fixed, const std::vector<char>& guide,
                              const std::vector<Matrix3d>& guides) {
    std::vector<Index> number(vertices, -1);
    std::vector<char> fixed_here, guide_here;
    const auto flag = [](const std::vector<char>& flags, Index vertex) {
        return static_cast<std::size_t>(vertex) < flags.size() ? flags[vertex] : char{0};
    };
    for (const Index vertex : some) {
        number[vertex] = static_cast<Index>(fixed_here.size());
        fixed_here.push_back(flag(fixed, vertex));
        if (!guides.empty()) guide_here.push_back(flag(guide, vertex));
    }
    std::vector<std::pair<Index, Index>> here;
    for (const auto& [i, j] : pairs)
        if (number[i] >= 0 && number[j] >= 0) here.emplace_back(number[i], number[j]);
    BlockMatrix matrix(static_cast<Index>(some.size()), here, std::move(fixed_here), std::move(guide_here),
                       guides);
    matrix.number = std::move(number);
    return matrix;
}

BlockMatrix BlockMatrix::diagonal(Index vertices) {
    BlockMatrix matrix(vertices, {}, std::vector<char>(vertices, 0));
    matrix.only_diagonal = true;
    return matrix;
}

Matrix3d BlockMatrix::diagonal_block(Index vertex) const {
    Matrix3d block;
    for (Index c = 0; c < 3; ++c)
        for (Index r = c; r < 3; ++r) block(r, c) = block(c, r) = value[column_start[3 * vertex + c] + r - c];
    return block;
}

Matrix3d BlockMatrix::block_below(Index index, Index column) const {
    Matrix3d block;
    for (Index c = 0; c < 3; ++c)
        block.col(c) = Eigen::Map<const Vector3d>(
            &value[column_start[3 * column + c] + 3 - c + 3 * (index - block_start[column])]);
    return block;
}

Positions BlockMatrix::times(const Positions& x) const {
    Positions product = Positions::Zero(3, x.cols());
    for (Index j = 0; j < static_cast<Index>(x.cols()); ++j) {
        product.col(j) += diagonal_block(j) * x.col(j);
        for (Index b = block_start[j]; b < block_start[j + 1]; ++b) {
            const Matrix3d block = block_below(b, j);
            product.col(block_row[b]) += block * x.col(j);
            product.col(j) += block.transpose() * x.col(block_row[b]);
        }
    }
    return product;
}

BlockMatrix BlockMatrix::restricted(const std::vector<char>& keep) const {
    std::vector<Index> kept;
    std::vector<std::pair<Index, Index>> pairs;
    for (Index j = 0; j < static_cast<Index>(keep.size()); ++j) {
        if (!keep[j]) continue;
        kept.push_back(j);
        for (Index b = block_start[j]; b < block_start[j + 1]; ++b) pairs.emplace_back(block_row[b], j);
    }
    BlockMatrix smaller = part(kept, static_cast<Index>(keep.size()), pairs, fixed, guide, guides);
    std::size_t at = 0;
    for (const Index j : kept)
        for (Index c = 0; c < 3; ++c) {
            const Index first = column_start[3 * j + c];
            for (Index r = c; r < 3; ++r) smaller.value[at++] = value[first + r - c];
            for (Index b = block_start[j]; b < block_start[j + 1]; ++b)
                if (keep[block_row[b]])
                    for (Index r = 0; r < 3; ++r)
                        smaller.value[at++] = value[first + 3 - c + 3 * (b - block_start[j]) + r];
        }
    smaller.number.clear();
    return smaller;
}

void BlockMatrix::find_blocks(Index vertices, const std::vector<std::pair<Index, Index>>& pairs) {
    std::vector<std::size_t> first(vertices + 1, 0);  // start of each column in `named`
    for (const auto& [i, j] : pairs) ++first[std::min(i, j) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> named(pairs.size());  // rows of each column, repeated as in `pairs`
    std::vector<std::size_t> next = first;
    for (const auto& [i, j] : pairs) named[next[std::min(i, j)]++] = std::max(i, j);

    std::vector<Index> last_column(vertices, -1);  // the last column in which each row was found
    block_start.push_back(0);
    for (Index j = 0; j < vertices; ++j) {
        last_column[j] = j;
        for (std::size_t k = first[j]; k < first[j + 1]; ++k)
            if (std::exchange(last_column[named[k]], j) != j) block_row.push_back(named[k]);
        std::sort(block_row.begin() + block_start.back(), block_row.end());
        block_start.push_back(static_cast<Index>(block_row.size()));
    }
}

void BlockMatrix::blend(std::span<const double> from, std::span<const double> to, double share) {
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = (1 - share) * from[i] + share * to[i];
}

void BlockMatrix::set_zero() {
    std::fill(value.begin(), value.end(), 0.0);
    for (Index v = 0; v < static_cast<Index>(fixed.size()); ++v) {
        if (fixed[v])
            add_free(0, v, v, Matrix3d::Identity());
        else if (guided(v))
            add_free(0, v, v, Matrix3d::Identity() - guides[guide[v] - 1]);
    }
}

Index BlockMatrix::rank(Index row, Index column) const {
    const auto rows = rows_of(column);
    return static_cast<Index>(std::ranges::lower_bound(rows, row) - rows.begin());
}

bool BlockMatrix::has(Index i, Index j) const {
    if (i == j) return true;
    const auto [column, below] = std::minmax(i, j);
    return is_at(rank(below, column), below, column);
}

Matrix3d BlockMatrix::guided_part(Index i, Index j, const Matrix3d& block) const {
    Matrix3d part = block;
    if (guided(i)) part = guides[guide[i] - 1] * part;
    if (guided(j)) part = part * guides[guide[j] - 1];
    return part;
}

void BlockMatrix::add(Index i, Index j, const Matrix3d& block) {
    if (i != j && only_diagonal) return;
    i = number_of(i);
    j = number_of(j);
    if (i < 0 || j < 0) return;
    if (i == j) return add_at(0, i, i, block);
    const auto [column, row] = std::minmax(i, j);
    const Index at = rank(row, column);
    if (is_part() && !is_at(at, row, column)) return;
    if (i > j)
        add_at(at, row, column, block);
    else
        add_at(at, row, column, block.transpose());
}

}  // namespace sherd
