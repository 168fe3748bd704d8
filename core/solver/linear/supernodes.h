// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/block_matrix.h"

namespace sherd {

/// The pattern of a Cholesky factor of a BlockMatrix, in block rows and columns, one for each vertex. Columns
/// with nearly the same rows are one supernode, whose part of the factor is dense (Liu 1990, "The role of
/// elimination trees in sparse factorization"). Rows and columns are numbered in the order of elimination,
/// children before parents.
struct Supernodes {
    std::vector<Index> place;        ///< [V] row of each vertex
    std::vector<Index> first;        ///< [S + 1] first column of each supernode
    std::vector<Index> of_column;    ///< [V] the supernode of each column
    std::vector<std::size_t> start;  ///< [S + 1] start of each supernode's part of `row`
    std::vector<Index> row;     ///< rows of each supernode, ascending: its own columns, then the rows below
    std::vector<Index> parent;  ///< [S] the supernode that contains the first row below; -1: none
    /// For each block below the diagonal of the matrix, in the order of BlockMatrix::block_rows(), the index
    /// of its row in the rows of the supernode that contains its column.
    std::vector<Index> block_place;

    Index size() const { return static_cast<Index>(parent.size()); }
    Index columns(Index node) const { return first[node + 1] - first[node]; }
    std::span<const Index> rows(Index node) const {
        return {row.data() + start[node], start[node + 1] - start[node]};
    }
    std::vector<Index> order() const;  ///< [V] the vertex of each row
    double factor_entries() const;     ///< number of entries of the factor
    double operations() const;         ///< estimated number of operations of a factorization
    std::span<const Index> rows_below(Index node) const { return rows(node).subspan(columns(node)); }
};

/// Finds the pattern with CHOLMOD, which also orders the vertices if `order` is empty. Throws
/// std::runtime_error when out of memory.
Supernodes supernodes(const BlockMatrix& matrix, const std::vector<Index>& order = {});

/// An order of elimination of the vertices of a matrix in which its factor stays sparse, [V].
std::vector<Index> elimination_order(const BlockMatrix& matrix);
/// Extends an order by further vertices, numbered from its size on, and places each directly after its
/// parent: a copy of a split vertex has a part of its parent's neighbours, so that a good order stays good.
std::vector<Index> with_children(const std::vector<Index>& order, const std::vector<Index>& parents);

}  // namespace sherd
