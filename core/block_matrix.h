// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/state_visitor.h"
#include "core/threads.h"
#include "core/vector.h"

namespace sherd {

/// Symmetric sparse matrix of 3 x 3 blocks, one block row and column for each vertex. It stores the lower
/// triangle in compressed columns with ascending rows, as CHOLMOD reads it. Coordinate c of vertex i has
/// scalar row 3 i + c.
class BlockMatrix {
  public:
    /// Zero matrix of `vertices` block rows with the blocks `pairs` (in any order, from either triangle,
    /// repeated or not) and all diagonal blocks. Rows and columns of `fixed` vertices stay rows and columns
    /// of the identity. `fixed` and `guide` may be shorter than the matrix, whose last vertices are then
    /// free. A vertex with guide[v] = k > 0 is restricted by the projection P = guides[k - 1]: its rows and
    /// columns are projected, and equal the identity's in the directions that P removes.
    BlockMatrix(Index vertices, const std::vector<std::pair<Index, Index>>& pairs, std::vector<char> fixed,
                std::vector<char> guide = {}, std::vector<Matrix3d> guides = {});
    /// A matrix with only the rows and columns of the vertices `some` (ascending), numbered from 0 in this
    /// order; other parameters are as in the constructor. add() still takes the numbers of all vertices, and
    /// ignores blocks that are not in the part.
    static BlockMatrix part(std::span<const Index> some, Index vertices,
                            const std::vector<std::pair<Index, Index>>& pairs, const std::vector<char>& fixed,
                            const std::vector<char>& guide, const std::vector<Matrix3d>& guides);
    /// A zero matrix of diagonal blocks alone, without fixed or guided vertices; add() ignores other blocks.
    static BlockMatrix diagonal(Index vertices);

    void set_zero();
    /// Whether the pattern has a block at block row i, block column j; blocks of fixed vertices count, too.
    bool has(Index i, Index j) const;
    /// Adds `block` at block row i, block column j. The caller adds each unordered pair once, since (j, i) is
    /// implied. A block on the diagonal must be symmetric. Blocks of fixed vertices are ignored.
    void add(Index i, Index j, const Matrix3d& block);
    class Columns;
    /// Adds the blocks of `size` elements. find(i, local) computes the data of element i in `local`, which
    /// may still hold the data of another element, and returns whether element i has blocks; it is called in
    /// any order, in several threads at a time. add(columns, i, local) adds the blocks of element i; each
    /// thread has its own `columns`. Every block is a sum in the order of elements, with the same bits
    /// whatever the number of threads.
    template <class Local, class Find, class Add>
    void add_elements(std::size_t size, const Find& find, const Add& add);
    /// Sets the threads that share the work of add_elements(); by default the calling thread alone.
    void share_among(Threads team) { threads = std::move(team); }
    const Threads& shared_among() const { return threads; }

    bool is_part() const { return !number.empty(); }
    /// Whether all blocks of an element with these vertices belong to this matrix. Negative numbers, which
    /// stand for no vertex, are skipped.
    bool has_all(std::span<const Index> vertices) const {
        return number.empty() ||
               std::ranges::all_of(vertices, [&](Index vertex) { return vertex < 0 || number[vertex] >= 0; });
    }
    Matrix3d diagonal_block(Index vertex) const;
    /// The block below the diagonal of a block column, by its index in block_rows().
    Matrix3d block_below(Index index, Index column) const;
    /// The matrix times x, [3, vertices].
    Positions times(const Positions& x) const;
    /// Returns the rows and columns of the vertices v with keep[v] != 0, renumbered from 0; `keep` is indexed
    /// by the vertex numbers of this matrix.
    BlockMatrix restricted(const std::vector<char>& keep) const;

    /// Sets the values to (1 - share) * from + share * to, where `from` and `to` are values() of this
    /// pattern.
    void blend(std::span<const double> from, std::span<const double> to, double share);

    Index size() const { return static_cast<Index>(column_start.size()) - 1; }  ///< number of scalar rows
    std::span<const Index> columns() const { return column_start; }             ///< [size + 1]
    std::span<const Index> rows() const { return row; }
    std::span<const double> values() const { return value; }
    // The blocks below the diagonal: compressed block columns with ascending block rows. In a scalar column,
    // their values follow the values of the diagonal block.
    std::span<const Index> block_columns() const { return block_start; }  ///< [vertices + 1]
    std::span<const Index> block_rows() const { return block_row; }
    /// Visits the pattern without the values.
    void visit_state(StateVisitor& visit) {
        auto& [block_start, block_row, column_start, row, value, fixed, guide, guides, number, only_diagonal,
               threads] = *this;
        visit(block_start, block_row, column_start, row, fixed, guide, guides, number, only_diagonal);
        value.resize(row.size());
    }

    void visit_values(StateVisitor& visit) { visit(value); }

  private:
    /// Number of a vertex in this matrix; -1 if this is a part without the vertex.
    Index number_of(Index vertex) const { return number.empty() ? vertex : number[vertex]; }
    /// Rows of the blocks below the diagonal of a column, ascending.
    std::span<const Index> rows_of(Index column) const {
        return std::span(block_row).subspan(block_start[column],
                                            block_start[column + 1] - block_start[column]);
    }
    bool guided(Index vertex) const { return !guides.empty() && guide[vertex] != 0; }
    /// Index of the block at (row, column) among the blocks below the diagonal of the column; if there is no
    /// such block, the index at which it would be inserted.
    Index rank(Index row, Index column) const;
    bool is_at(Index rank, Index row, Index column) const {
        const auto rows = rows_of(column);
        return rank < static_cast<Index>(rows.size()) && rows[rank] == row;
    }
    void find_blocks(Index vertices, const std::vector<std::pair<Index, Index>>& pairs);
    /// Adds a block with i >= j. rank: see rank(); used only if i > j.
    void add_at(Index rank, Index i, Index j, const Matrix3d& block);
    /// Adds a block as it is, whether or not its vertices are fixed or guided; parameters as in add_at().
    void add_free(Index rank, Index i, Index j, const Matrix3d& block);
    /// The block, projected for each of its vertices that is guided.
    Matrix3d guided_part(Index i, Index j, const Matrix3d& block) const;

    std::vector<Index> block_start;  ///< [vertices + 1] first below-diagonal block of each block column
    std::vector<Index> block_row;    ///< block rows below the diagonal, ascending within a column
    std::vector<Index> column_start, row;
    std::vector<double> value;
    std::vector<char> fixed, guide;
    std::vector<Matrix3d> guides;
    /// Number of each vertex in this part, -1: not in the part; empty: this is no part.
    std::vector<Index> number;
    bool only_diagonal = false;
    Threads threads;
};

inline void BlockMatrix::add_free(Index rank, Index i, Index j, const Matrix3d& block) {
    for (Index c = 0; c < 3; ++c) {
        double* const diagonal = &value[column_start[3 * j + c]];
        if (i == j) {
            for (Index r = c; r < 3; ++r) diagonal[r - c] += block(r, c);
        } else {
            double* const below = diagonal + 3 - c + 3 * rank;
            Eigen::Map<Vector2d>{below} += block.col(c).head<2>();
            below[2] += block(2, c);
        }
    }
}

inline void BlockMatrix::add_at(Index rank, Index i, Index j, const Matrix3d& block) {
    if (fixed[i] || fixed[j]) return;
    if (guided(i) || guided(j))
        add_free(rank, i, j, guided_part(i, j, block));
    else
        add_free(rank, i, j, block);
}

/// Adds the symmetric Hessian `local` [3 N, 3 N] of an element with `vertices` [N] (coordinate fastest) to a
/// BlockMatrix or to some of its columns.
/// Vertices with negative numbers are skipped.
template <class Matrix, std::size_t N>
void add_element(Matrix& matrix, const std::array<Index, N>& vertices,
                 const Eigen::Matrix<double, 3 * N, 3 * N>& local) {
    for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b <= a; ++b)
            if (vertices[a] >= 0 && vertices[b] >= 0)
                matrix.add(vertices[a], vertices[b], local.template block<3, 3>(3 * a, 3 * b));
}

/// Appends the unordered pairs of an element's vertices, without vertices of negative number.
template <std::size_t N>
void add_pairs(std::vector<std::pair<Index, Index>>& pairs, const std::array<Index, N>& vertices) {
    for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (vertices[a] >= 0 && vertices[b] >= 0) pairs.emplace_back(vertices[a], vertices[b]);
}

/// Subtracts `first` from the vertices' numbers.
template <std::size_t N>
std::array<Index, N> numbered_from(std::array<Index, N> vertices, Index first) {
    for (Index& vertex : vertices) vertex -= first;
    return vertices;
}

}  // namespace sherd
