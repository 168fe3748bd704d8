// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/block_matrix.h"

namespace sherd {

/// Some block columns of a matrix. Blocks added to its other columns are ignored.
class BlockMatrix::Columns {
  public:
    /// The columns in part number `part`, if the columns of the matrix are divided into `parts` parts. Most
    /// adjacent columns are in one part.
    explicit Columns(BlockMatrix& matrix, Index part = 0, Index parts = 1)
        : matrix(matrix), part(part), parts(parts) {}
    void add(Index i, Index j, const Matrix3d& block) {
        if (has(std::min(i, j))) matrix.add(i, j, block);
    }
    /// Adds block(a, b) at block row vertices[a], block column vertices[b] for all a >= b, like add(), but
    /// faster for many vertices. The vertices must ascend, and every pair of them must have a block; in a
    /// part of a matrix, every pair of vertices that are both in the part.
    template <class Block>
    void add_all(std::span<const Index> vertices, const Block& block);
    /// Three rows with three columns for each vertex, coordinate fastest.
    using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
    /// Adds the blocks of rows^T rows, [3 N, 3 N] for N vertices, like add_all().
    void add_square(std::span<const Index> vertices, const Rows& rows);

  private:
    /// Writes column c of rows^T rows, from row `first` on, to `column`.
    static void square_column(const Rows& rows, Eigen::Index c, Eigen::Index first, double* column);
    bool is_plain(std::span<const Index> vertices) const;
    static constexpr Index run = 16;  // number of consecutive columns in a part, for caches
    bool has(Index column) const { return parts == 1 || column / run % parts == part; }

    BlockMatrix& matrix;
    Index part, parts;
    std::vector<double> buffer;  ///< a scalar column of rows^T rows
    std::vector<Index> ranks;    ///< ranks of the blocks of a column: see BlockMatrix::rank()
    std::vector<Index> here;     ///< numbers of an element's vertices in the matrix
};

template <class Block>
void BlockMatrix::Columns::add_all(std::span<const Index> vertices, const Block& block) {
    for (std::size_t b = 0; b < vertices.size(); ++b) {
        const Index column = matrix.number_of(vertices[b]);
        if (column < 0 || !has(vertices[b])) continue;
        matrix.add_at(0, column, column, block(b, b));
        const auto rows = matrix.rows_of(column);
        auto found = rows.begin();
        for (std::size_t a = b + 1; a < vertices.size(); ++a) {
            const Index row = matrix.number_of(vertices[a]);
            found = std::find_if(found, rows.end(), [&](Index other) { return other >= row; });
            if (found == rows.end()) break;
            if (*found == row)
                matrix.add_at(static_cast<Index>(found - rows.begin()), row, column, block(a, b));
        }
    }
}

template <class Local, class Find, class Add>
void BlockMatrix::add_elements(std::size_t size, const Find& find, const Add& add) {
    struct Found {
        Local local;
        bool any;
    };
    std::vector<Columns> parts;
    for (Index part = 0; part < threads.count(); ++part) parts.emplace_back(*this, part, threads.count());
    threads.share_lots<Found>(
        size, [&](std::size_t i, Found& found) { found.any = find(i, found.local); },
        [&](std::size_t first, std::span<const Found> lot) {
            const auto add_to = [&](Columns& columns) {
                for (std::size_t i = 0; i < lot.size(); ++i)
                    if (lot[i].any) add(columns, first + i, lot[i].local);
            };
            if (parts.size() == 1) return add_to(parts[0]);
            threads.share(threads.count(), [&](Index part) { add_to(parts[part]); });
        });
}

}  // namespace sherd
