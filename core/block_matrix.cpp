// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/block_matrix.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sherd {

BlockMatrix::BlockMatrix(Index vertices, const std::vector<std::pair<Index, Index>>& pairs,
                         std::vector<char> fixed, std::vector<char> guide, std::vector<Matrix3d> guides)
    : fixed(std::move(fixed)), guide(std::move(guide)), guides(std::move(guides)) {
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

void BlockMatrix::find_blocks(Index vertices, const std::vector<std::pair<Index, Index>>& pairs) {
    std::vector<std::size_t> first(vertices + 1, 0);  // of each column in `named`
    for (const auto& [i, j] : pairs) ++first[std::min(i, j) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> named(pairs.size());  // rows, as often as pairs name them
    std::vector<std::size_t> next = first;
    for (const auto& [i, j] : pairs) named[next[std::min(i, j)]++] = std::max(i, j);

    std::vector<Index> last_column(vertices, -1);  // in which a row was found
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
    const auto first = block_row.begin() + block_start[column];
    const auto found = std::lower_bound(first, block_row.begin() + block_start[column + 1], row);
    return static_cast<Index>(found - first);
}

bool BlockMatrix::has(Index i, Index j) const {
    if (i == j) return true;
    const auto [column, below] = std::minmax(i, j);
    const Index block = block_start[column] + rank(below, column);
    return block < block_start[column + 1] && block_row[block] == below;
}

Matrix3d BlockMatrix::guided_part(Index i, Index j, const Matrix3d& block) const {
    Matrix3d part = block;
    if (guided(i)) part = guides[guide[i] - 1] * part;
    if (guided(j)) part = part * guides[guide[j] - 1];
    return part;
}

void BlockMatrix::add(Index i, Index j, const Matrix3d& block) {
    if (i == j)
        add_at(0, i, i, block);
    else if (i > j)
        add_at(rank(i, j), i, j, block);
    else
        add_at(rank(j, i), j, i, block.transpose());
}

}  // namespace sherd
