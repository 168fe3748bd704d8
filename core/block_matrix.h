// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Symmetric sparse matrix of 3 x 3 blocks, one block row and column a vertex. Holds the lower triangle in
/// compressed columns, rows ascending, which is how CHOLMOD reads it. Scalar row of coordinate c of vertex i:
/// 3 i + c.
class BlockMatrix {
  public:
    /// Zero matrix of `vertices` block rows with the blocks `pairs` (any order, either triangle, repeats
    /// allowed) and all diagonal blocks. Rows and columns of `fixed` vertices (one flag a vertex) stay those
    /// of the identity.
    /// A vertex with guide[v] = k > 0 has the freedom of guides[k - 1], a projection P: its rows and columns
    /// are projected, and stay those of the identity in the directions that P takes away.
    BlockMatrix(Index vertices, std::vector<std::pair<Index, Index>> pairs, std::vector<char> fixed,
                std::vector<char> guide = {}, std::vector<Matrix3d> guides = {});

    void set_zero();
    /// Whether there is a block at block row i, block column j, or would be were its vertices not fixed.
    bool has(Index i, Index j) const;
    /// Adds `block` at block row i, block column j. The caller adds each unordered pair once: (j, i) is
    /// implied. A block on the diagonal must be symmetric. Blocks of fixed vertices are ignored.
    void add(Index i, Index j, const Matrix3d& block);

    /// Sets the values to (1 - share) `from` + share `to`, both values() of this pattern.
    void blend(std::span<const double> from, std::span<const double> to, double share);

    Index size() const { return static_cast<Index>(column_start.size()) - 1; }  ///< scalar rows
    std::span<const Index> columns() const { return column_start; }             ///< [size + 1]
    std::span<const Index> rows() const { return row; }
    std::span<const double> values() const { return value; }

  private:
    bool guided(Index vertex) const { return !guides.empty() && guide[vertex] != 0; }
    /// Number below the diagonal of the block at (row, column), or of the one where it should be inserted.
    Index rank(Index row, Index column) const;
    void add_diagonal(Index vertex, const Matrix3d& block);

    std::vector<Index> block_start;  ///< [vertices + 1] first below-diagonal block of each block column
    std::vector<Index> block_row;    ///< block rows below the diagonal, ascending within a column
    std::vector<Index> column_start, row;
    std::vector<double> value;
    std::vector<char> fixed, guide;
    std::vector<Matrix3d> guides;
};

/// Adds the symmetric `local` Hessian [3 N, 3 N] of an element on `vertices` [N] (coordinate fastest).
/// Vertices below zero are none of the matrix's.
template <std::size_t N>
void add_element(BlockMatrix& matrix, const std::array<Index, N>& vertices,
                 const Eigen::Matrix<double, 3 * N, 3 * N>& local) {
    for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b <= a; ++b)
            if (vertices[a] >= 0 && vertices[b] >= 0)
                matrix.add(vertices[a], vertices[b], local.template block<3, 3>(3 * a, 3 * b));
}

/// Appends the unordered pairs of an element's vertices, but for those below zero.
template <std::size_t N>
void add_pairs(std::vector<std::pair<Index, Index>>& pairs, const std::array<Index, N>& vertices) {
    for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (vertices[a] >= 0 && vertices[b] >= 0) pairs.emplace_back(vertices[a], vertices[b]);
}

/// Vertices numbered from `first` on.
template <std::size_t N>
std::array<Index, N> numbered_from(std::array<Index, N> vertices, Index first) {
    for (Index& vertex : vertices) vertex -= first;
    return vertices;
}

}  // namespace sherd
