// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/block_matrix.h"

#include <algorithm>

namespace sherd {

BlockMatrix::BlockMatrix(Index vertices, std::vector<std::pair<Index, Index>> pairs, std::vector<char> fixed,
                         std::vector<char> guide, std::vector<Matrix3d> guides)
    : fixed(std::move(fixed)), guide(std::move(guide)), guides(std::move(guides)) {
    for (auto& [column, below] : pairs)
        if (column > below) std::swap(column, below);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });

    block_start.assign(vertices + 1, 0);
    for (const auto& [column, below] : pairs) {
        ++block_start[column + 1];
        block_row.push_back(below);
    }
    for (Index j = 0; j < vertices; ++j) block_start[j + 1] += block_start[j];

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

void BlockMatrix::blend(std::span<const double> from, std::span<const double> to, double share) {
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = (1 - share) * from[i] + share * to[i];
}

void BlockMatrix::set_zero() {
    std::fill(value.begin(), value.end(), 0.0);
    for (Index v = 0; v < static_cast<Index>(fixed.size()); ++v) {
        if (fixed[v])
            add_diagonal(v, Matrix3d::Identity());
        else if (guided(v))
            add_diagonal(v, Matrix3d::Identity() - guides[guide[v] - 1]);
    }
}

void BlockMatrix::add_diagonal(Index vertex, const Matrix3d& block) {
    for (Index c = 0; c < 3; ++c)
        for (Index r = c; r < 3; ++r) value[column_start[3 * vertex + c] + r - c] += block(r, c);
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

void BlockMatrix::add(Index i, Index j, const Matrix3d& unconstrained) {
    if (fixed[i] || fixed[j]) return;
    Matrix3d block = unconstrained;
    if (guided(i)) block = guides[guide[i] - 1] * block;
    if (guided(j)) block = block * guides[guide[j] - 1];
    if (i == j) return add_diagonal(j, block);
    const bool lower = i > j;
    const Index column = lower ? j : i, below = lower ? i : j;
    const Index offset = 3 * rank(below, column);
    for (Index c = 0; c < 3; ++c) {
        double* target = &value[column_start[3 * column + c] + (3 - c) + offset];
        for (Index r = 0; r < 3; ++r) target[r] += lower ? block(r, c) : block(c, r);
    }
}

}  // namespace sherd
