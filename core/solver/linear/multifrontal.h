// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/solver/linear/supernodes.h"
#include "core/threads.h"

namespace sherd {

/// Consecutive supernodes that form whole subtrees, so that they can be eliminated in parallel with other
/// parts.
struct EliminationPart {
    Index first = 0, end = 0;             ///< first supernode, and one past the last
    Index first_column = 0, columns = 0;  ///< first column of these supernodes, and their number of columns
    std::vector<Index> outside;  ///< rows of these supernodes after all columns of the part, ascending
};

/// Division of a factor's supernodes among threads: the parts are eliminated in parallel, then the supernodes
/// above them one by one.
struct EliminationParts {
    explicit EliminationParts(const Supernodes& pattern);

    std::vector<EliminationPart> parts;
    std::vector<Index> above;    ///< supernodes above the parts, ascending
    std::vector<char> is_above;  ///< [S] whether each supernode is above the parts
    /// For each entry of Supernodes::row, the index of this row in the vector with which its supernode is
    /// solved: for a supernode in a part, a vector of the part's columns and then its rows outside; for a
    /// supernode above, a vector of all rows.
    std::vector<Index> place;
};

/// Cholesky factor of a positive definite BlockMatrix in numbers of type Real, by the multifrontal method
/// (Duff, Reid 1983; Liu 1992, "The multifrontal method for sparse matrix solution"). float takes half the
/// memory and half the time of double, and is as good where solutions are corrected afterwards. The factor
/// has the same bits with any number of threads.
template <class Real>
class MultifrontalFactor {
  public:
    explicit MultifrontalFactor(std::shared_ptr<const Supernodes> pattern, Threads threads = Threads());
    /// Returns false if the matrix is not positive definite, or too badly scaled to decide.
    bool factorize(const BlockMatrix& matrix);
    /// After factorize() has returned false: the pivot that was not positive, over the size of the matrix's
    /// diagonal entry in its column; 0 if the pivot is infinite or not a number.
    double failed_pivot() const { return pivot; }
    VectorXd solve(const VectorXd& right_side) const;  ///< right side, solution: [3 V]

  private:
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    /// Stack of the update matrices of supernodes: a supernode's contribution to the rows below it, [3 rows,
    /// 3 rows], of which only the lower triangle is used.
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
    /// Largest number of values on the stack of `nodes`, which are eliminated in this order.
    std::size_t stack_size(const std::vector<Index>& nodes) const;
    /// Number of values of the update matrices of those children of a supernode that are on its stack.
    std::size_t size_of_children(Index node) const;
    void scatter(const BlockMatrix& matrix);
    void scatter_column(const BlockMatrix& matrix, Index vertex);
    /// Columns of a supernode's frontal matrix: its own, or the columns of the rows below.
    enum class Columns { own, below };
    /// Adds the part of a child's update matrix in `columns` of its parent `node` to `target`, these columns.
    void extend(Index child, Index node, Columns columns, Real* target) const;
    /// Eliminates the columns of a supernode. Returns 1 if all pivots are positive, else the value of
    /// failed_pivot().
    double eliminate(Index node, Stack& stack, const Threads& team);

    void solve_forward(Index node, Vector& y, Vector& below) const;
    void solve_backward(Index node, Vector& y, Vector& below) const;

    std::shared_ptr<const Supernodes> pattern;
    Threads threads;
    EliminationParts shares;
    std::vector<std::size_t> start;            ///< [S + 1] start of each supernode's part of `values`
    std::vector<Real> values;                  ///< [height, width] of each supernode, column by column
    std::vector<std::vector<Index>> children;  ///< [S] children of each supernode
    std::vector<Index> in_parent;       ///< for each entry of Supernodes::row, its index in the parent's rows
    std::vector<Stack> stacks;          ///< buffers: one for each part, and one for the supernodes above
    std::vector<const Real*> update;    ///< [S] update matrix of each supernode, in `stacks`
    std::vector<Real> diagonal_before;  ///< [3 V] diagonal of the matrix, in the order of elimination
    double pivot = 1;
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace sherd
