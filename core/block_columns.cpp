// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/block_columns.h"

#include <algorithm>

#include "core/lanes.h"

namespace sherd {

void BlockMatrix::Columns::square_column(const Rows& rows, Eigen::Index c, Eigen::Index first,
                                         double* column) {
    const double first_of = rows(0, c), second_of = rows(1, c), third_of = rows(2, c);
    const double *const x = rows.row(0).data(), *const y = rows.row(1).data(), *const z = rows.row(2).data();
    Eigen::Index r = first;
    for (; r + Lanes::count <= rows.cols(); r += Lanes::count)
        (Lanes::load(x + r) * first_of + Lanes::load(y + r) * second_of + Lanes::load(z + r) * third_of)
            .store(column + r);
    for (; r < rows.cols(); ++r) column[r] = x[r] * first_of + y[r] * second_of + z[r] * third_of;
}

bool BlockMatrix::Columns::is_plain(std::span<const Index> vertices) const {
    return !matrix.only_diagonal && std::ranges::none_of(vertices, [&](Index v) {
        const Index here = matrix.number_of(v);
        return here < 0 || matrix.guided(here);
    });
}

void BlockMatrix::Columns::add_square(std::span<const Index> vertices, const Rows& rows) {
    if (!is_plain(vertices)) {
        add_all(vertices, [&](std::size_t a, std::size_t b) -> Matrix3d {
            return rows.middleCols<3>(3 * static_cast<Eigen::Index>(a)).transpose() *
                   rows.middleCols<3>(3 * static_cast<Eigen::Index>(b));
        });
        return;
    }
    buffer.resize(rows.cols());
    ranks.resize(vertices.size());
    here.clear();
    for (const Index vertex : vertices) here.push_back(matrix.number_of(vertex));
    wide_loop(0, static_cast<int>(vertices.size()), [&](int b) {
        const Index column = here[b];
        if (!has(vertices[b]) || matrix.fixed[column]) return;
        const Index* const block_rows = matrix.block_row.data() + matrix.block_start[column];
        Index rank = 0;
        for (std::size_t a = b + 1; a < vertices.size(); ++a) {
            while (block_rows[rank] < here[a]) ++rank;
            ranks[a] = rank;
        }
        for (Index c = 0; c < 3; ++c) {
            square_column(rows, 3 * b + c, 3 * b, buffer.data());
            double* const diagonal = &matrix.value[matrix.column_start[3 * column + c]];
            for (Index r = c; r < 3; ++r) diagonal[r - c] += buffer[3 * b + r];
            double* const below = diagonal + 3 - c;
            for (std::size_t a = b + 1; a < vertices.size(); ++a) {
                if (matrix.fixed[here[a]]) continue;
                double* const block = below + 3 * ranks[a];
                for (int r = 0; r < 3; ++r) block[r] += buffer[3 * a + r];
            }
        }
    });
}

}  // namespace sherd
