// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/solver/linear/supernodes.h"
#include "core/threads.h"

namespace sherd {

/// Consecutive supernodes, of whole subtrees, which can be eliminated in parallel with other parts.
struct EliminationPart {
    Index first = 0, end = 0;             ///< supernodes
    Index first_column = 0, columns = 0;  ///< consecutive columns of these supernodes
    std::vector<Index> outside;           ///< rows of these supernodes after these columns, ascending
};

/// Division of a factor's supernodes among threads: parts in parallel, then the supernodes above, one by one.
struct EliminationParts {
    explicit EliminationParts(const Supernodes& pattern);

    std::vector<EliminationPart> parts;
    std::vector<Index> above;    ///< supernodes, ascending
    std::vector<char> is_above;  ///< [S]
    /// For each entry of Supernodes::row its index in a vector with the columns of its part and then the rows
    /// outside; for supernodes above, in a vector of all rows.
    std::vector<Index> place;
};

/// Cholesky factor of a positive definite BlockMatrix in numbers of type Real, by the multifrontal method
/// (Duff, Reid 1983; Liu 1992, "The multifrontal method for sparse matrix solution"). float takes half the
/// memory and half the time of double, and is as good where solutions are corrected afterwards. It has the
/// same bits with any number of threads.
template <class Real>
class MultifrontalFactor {
  public:
    explicit MultifrontalFactor(std::shared_ptr<const Supernodes> pattern, Threads threads = Threads());
    /// Returns false if the matrix is not positive definite, or too badly scaled to decide.
    bool factorize(const BlockMatrix& matrix);
    /// The pivot that was not positive, over the diagonal entry of the matrix there, after factorize() has
    /// returned false.
    double failed_pivot() const { return pivot; }
    VectorXd solve(const VectorXd& right_side) const;  ///< [3 V]

  private:
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    /// Update matrices of supernodes for the rows below them, [3 rows, 3 rows] each, of which the lower
    /// triangle is used.
    struct Stack {
        std::vector<Real> values;
        std::size_t top = 0;
    };

    Index height(Index node) const { return 3 * static_cast<Index>(pattern->rows(node).size()); }
    Index width(Index node) const { return 3 * pattern->columns(node); }
    std::size_t update_size(Index node) const;
    Real* panel(Index node) { return values.data() + start[node]; }
    const Real* panel(Index node) const { return values.data() + start[node]; }
    /// Indices of a supernode's rows in a vector: see EliminationParts::place.
    const Index* places(Index node) const { return shares.place.data() + pattern->start[node]; }

    void find_children();
    /// Largest size of the stack of supernodes that are eliminated together.
    std::size_t stack_size(const std::vector<Index>& nodes) const;
    /// Size of the update matrices of a supernode's children on its stack.
    std::size_t size_of_children(Index node) const;
    void scatter(const BlockMatrix& matrix);
    void scatter_column(const BlockMatrix& matrix, Index vertex);
    /// Columns of a supernode's rows: its own, or those of the rows below.
    enum class Columns { own, below };
    /// Adds a child's update matrix to those columns of its parent.
    void extend(Index child, Index node, Columns columns, Real* target) const;
    /// Eliminates the columns of a supernode. Returns 1, or the value of failed_pivot().
    double eliminate(Index node, Stack& stack, const Threads& team);

    void solve_forward(Index node, Vector& y, Vector& below) const;
    void solve_backward(Index node, Vector& y, Vector& below) const;

    std::shared_ptr<const Supernodes> pattern;
    Threads threads;
    EliminationParts shares;
    std::vector<std::size_t> start;            ///< [S + 1] start of each supernode's part of `values`
    std::vector<Real> values;                  ///< [height, width] of each supernode, column by column
    std::vector<std::vector<Index>> children;  ///< [S]
    std::vector<Index> in_parent;       ///< index in the parent's rows of each entry of Supernodes::row
    std::vector<Stack> stacks;          ///< buffers: one for each part, and one for the supernodes above
    std::vector<const Real*> update;    ///< [S] update matrix of each supernode, in `stacks`
    std::vector<Real> diagonal_before;  ///< [3 V] diagonal of the matrix, in the order of elimination
    double pivot = 1;
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace sherd
