// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/solver/elimination_parts.h"
#include "core/threads.h"

namespace sherd {

/// Cholesky factor of a positive definite BlockMatrix in numbers of type Real, by the multifrontal method
/// (Duff, Reid 1983; Liu 1992, "The multifrontal method for sparse matrix solution"). float takes half the
/// memory and half the time of double, and is as good where solutions are corrected anyhow. It has the same
/// bits with any number of threads.
template <class Real>
class MultifrontalFactor {
  public:
    explicit MultifrontalFactor(std::shared_ptr<const Supernodes> pattern, Threads threads = Threads());
    /// Returns false if the matrix is not positive definite, or too badly scaled to tell.
    bool factorize(const BlockMatrix& matrix);
    /// After a matrix that was not: the pivot that was not positive, as a share of what the diagonal had
    /// there.
    double failed_pivot() const { return pivot; }
    VectorXd solve(const VectorXd& right_side) const;  ///< [3 V]

  private:
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    /// What supernodes leave for the rows below them, [3 rows, 3 rows] each, of which the lower triangle
    /// counts.
    struct Stack {
        std::vector<Real> values;
        std::size_t top = 0;
    };

    Index height(Index node) const { return 3 * static_cast<Index>(pattern->rows(node).size()); }
    Index width(Index node) const { return 3 * pattern->columns(node); }
    std::size_t update_size(Index node) const;
    Real* panel(Index node) { return values.data() + start[node]; }
    const Real* panel(Index node) const { return values.data() + start[node]; }
    /// Where the rows of a supernode are in a vector, see EliminationParts::place.
    const Index* places(Index node) const { return shares.place.data() + pattern->start[node]; }

    void find_children();
    /// How large the stack becomes of supernodes that are eliminated together.
    std::size_t stack_size(const std::vector<Index>& nodes) const;
    /// What the children of a supernode have left on its stack.
    std::size_t size_of_children(Index node) const;
    void scatter(const BlockMatrix& matrix);
    void scatter_column(const BlockMatrix& matrix, Index vertex);
    /// Which columns of a supernode's rows are meant.
    enum class Columns { own, below };
    /// Adds what a child leaves to those columns of its parent.
    void extend(Index child, Index node, Columns columns, Real* target) const;
    /// Eliminates the columns of a supernode. Returns 1, or what failed_pivot() is to be.
    double eliminate(Index node, Stack& stack, const Threads& team);

    void solve_forward(Index node, Vector& y, Vector& below) const;
    void solve_backward(Index node, Vector& y, Vector& below) const;

    std::shared_ptr<const Supernodes> pattern;
    Threads threads;
    EliminationParts shares;
    std::vector<std::size_t> start;            ///< [S + 1] of each supernode's part of `values`
    std::vector<Real> values;                  ///< [height, width] of each supernode, column by column
    std::vector<std::vector<Index>> children;  ///< [S]
    std::vector<Index> in_parent;              ///< of each of Supernodes::row its place in the parent's rows
    std::vector<Stack> stacks;                 ///< buffers: of each part, and of what is above
    std::vector<const Real*> update;           ///< [S] in them, what each supernode has left
    std::vector<Real> diagonal_before;         ///< [3 V] of the matrix, in the order of elimination
    double pivot = 1;
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace sherd
