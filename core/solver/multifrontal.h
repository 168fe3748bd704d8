// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/solver/supernodes.h"

namespace sherd {

/// Cholesky factor of a positive definite BlockMatrix in numbers of type Real, by the multifrontal method
/// (Duff, Reid 1983; Liu 1992, "The multifrontal method for sparse matrix solution"). float takes half the
/// memory and half the time of double, and is as good where solutions are corrected anyhow.
template <class Real>
class MultifrontalFactor {
  public:
    explicit MultifrontalFactor(std::shared_ptr<const Supernodes> pattern);
    /// Returns false if the matrix is not positive definite, or too badly scaled to tell.
    bool factorize(const BlockMatrix& matrix);
    VectorXd solve(const VectorXd& right_side) const;  ///< [3 V]

  private:
    Index height(Index node) const { return 3 * static_cast<Index>(pattern->rows(node).size()); }
    Index width(Index node) const { return 3 * pattern->columns(node); }
    std::size_t update_size(Index node) const;
    Real* panel(Index node) { return values.data() + start[node]; }
    const Real* panel(Index node) const { return values.data() + start[node]; }
    void scatter(const BlockMatrix& matrix);
    /// Which columns of a supernode's rows are meant.
    enum class Columns { own, below };
    /// Adds what a child leaves to those columns of its parent.
    void extend(Index child, const Real* of_child, Index node, Columns columns, Real* target);
    /// Eliminates the columns of a supernode. Returns false if they are not positive definite.
    bool eliminate(Index node);

    std::shared_ptr<const Supernodes> pattern;
    std::vector<std::size_t> start;            ///< [S + 1] of each supernode's part of `values`
    std::vector<Real> values;                  ///< [height, width] of each supernode, column by column
    std::vector<std::vector<Index>> children;  ///< [S]
    /// Buffers: the stack of what supernodes leave for the rows below them, [3 rows, 3 rows] each, of which
    /// the lower triangle counts; and [V] the places of rows in a supernode's rows.
    std::vector<Real> updates;
    std::vector<Index> local;
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace sherd
