// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <stdexcept>

#include "core/solver/linear/cholmod_session.h"
#include "core/solver/linear/factor_size.h"
#include "core/solver/linear/linear_solver.h"
#include "core/solver/linear/supernodes.h"

namespace sherd {
namespace {

/// CHOLMOD's functions for indices of type Integer.
template <class Integer>
struct Cholmod;
template <>
struct Cholmod<int> {
    static constexpr bool wide = false;
    static constexpr auto analyze = cholmod_analyze;
    static constexpr auto analyze_p = cholmod_analyze_p;
    static constexpr auto factorize = cholmod_factorize;
    static constexpr auto solve = cholmod_solve2;
    static constexpr auto free_dense = cholmod_free_dense;
    static constexpr auto free_factor = cholmod_free_factor;
};
template <>
struct Cholmod<SuiteSparse_long> {
    static constexpr bool wide = true;
    static constexpr auto analyze = cholmod_l_analyze;
    static constexpr auto analyze_p = cholmod_l_analyze_p;
    static constexpr auto factorize = cholmod_l_factorize;
    static constexpr auto solve = cholmod_l_solve2;
    static constexpr auto free_dense = cholmod_l_free_dense;
    static constexpr auto free_factor = cholmod_l_free_factor;
};

/// View of a BlockMatrix for CHOLMOD; indices are copied only if their type is not Index.
template <class Integer>
class CholmodMatrix {
  public:
    void set_pattern(const BlockMatrix& matrix) {
        if constexpr (Cholmod<Integer>::wide) {
            columns.assign(matrix.columns().begin(), matrix.columns().end());
            rows.assign(matrix.rows().begin(), matrix.rows().end());
        }
    }
    /// matrix: must have the pattern that set_pattern() was given.
    cholmod_sparse view(const BlockMatrix& matrix) const {
        cholmod_sparse sparse{};
        sparse.nrow = sparse.ncol = static_cast<std::size_t>(matrix.size());
        sparse.nzmax = matrix.values().size();
        if constexpr (Cholmod<Integer>::wide) {
            sparse.p = const_cast<Integer*>(columns.data());
            sparse.i = const_cast<Integer*>(rows.data());
        } else {
            sparse.p = const_cast<Index*>(matrix.columns().data());
            sparse.i = const_cast<Index*>(matrix.rows().data());
        }
        sparse.x = const_cast<double*>(matrix.values().data());
        sparse.stype = -1;
        sparse.itype = Cholmod<Integer>::wide ? CHOLMOD_LONG : CHOLMOD_INT;
        sparse.xtype = CHOLMOD_REAL;
        sparse.dtype = CHOLMOD_DOUBLE;
        sparse.sorted = sparse.packed = 1;
        return sparse;
    }

  private:
    std::vector<Integer> columns, rows;
};

/// Number of operations of a factorization that take as long as one entry of the factor in a solution.
constexpr double operations_per_entry = 30;

/// The elimination order of the unknowns if vertices are eliminated in the order `vertices`.
template <class Integer>
std::vector<Integer> of_unknowns(const std::vector<Index>& vertices) {
    std::vector<Integer> order;
    order.reserve(3 * vertices.size());
    for (const Index vertex : vertices)
        for (Integer c = 0; c < 3; ++c) order.push_back(Integer{3} * vertex + c);
    return order;
}

/// A factor by CHOLMOD.
template <class Integer>
class CholmodFactor {
  public:
    using Calls = Cholmod<Integer>;

    /// supernodal: whether to compute L L^T, for positive definite matrices; if not, L D L^T.
    explicit CholmodFactor(bool supernodal) : session(Calls::wide) {
        session.common.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    }
    ~CholmodFactor() {
        Calls::free_dense(&solution, common());
        Calls::free_dense(&work1, common());
        Calls::free_dense(&work2, common());
        Calls::free_factor(&factor, common());
    }
    CholmodFactor(const CholmodFactor&) = delete;

    /// order: elimination order of the vertices. Returns false if the factor has more entries than indices
    /// can count.
    bool analyze(const BlockMatrix& matrix, const std::vector<Index>& order);
    bool factorize(const BlockMatrix& matrix);
    VectorXd solve(const VectorXd& right_side);
    double operations() const { return session.common.fl; }
    double entries() const { return session.common.lnz; }

  private:
    cholmod_common* common() { return &session.common; }

    CholmodSession session;
    CholmodMatrix<Integer> pattern;
    cholmod_factor* factor = nullptr;
    cholmod_dense *solution = nullptr, *work1 = nullptr, *work2 = nullptr;
};

template <class Integer>
bool CholmodFactor<Integer>::analyze(const BlockMatrix& matrix, const std::vector<Index>& of_vertices) {
    pattern.set_pattern(matrix);
    cholmod_sparse sparse = pattern.view(matrix);
    std::vector<Integer> order = of_unknowns<Integer>(of_vertices);
    common()->method[0].ordering = CHOLMOD_GIVEN;
    factor = Calls::analyze_p(&sparse, order.data(), nullptr, 0, common());
    if (common()->status == CHOLMOD_TOO_LARGE) return false;
    session.require(factor != nullptr, "analyze the matrix");
    return true;
}

template <class Integer>
bool CholmodFactor<Integer>::factorize(const BlockMatrix& matrix) {
    cholmod_sparse sparse = pattern.view(matrix);
    const bool success = Calls::factorize(&sparse, factor, common());
    if (common()->status == CHOLMOD_NOT_POSDEF) return false;
    session.require(success, "factorize the matrix");
    return factor->minor == factor->n;
}

template <class Integer>
VectorXd CholmodFactor<Integer>::solve(const VectorXd& right_side) {
    cholmod_dense dense{};
    dense.nrow = dense.nzmax = dense.d = static_cast<std::size_t>(right_side.size());
    dense.ncol = 1;
    dense.x = const_cast<double*>(right_side.data());
    dense.xtype = CHOLMOD_REAL;
    dense.dtype = CHOLMOD_DOUBLE;
    const bool success =
        Calls::solve(CHOLMOD_A, factor, &dense, nullptr, &solution, nullptr, &work1, &work2, common());
    session.require(success, "solve");
    return Eigen::Map<const VectorXd>(static_cast<const double*>(solution->x), right_side.size());
}

class CholeskySolver : public LinearSolver {
  public:
    CholeskySolver(bool supernodal, Indices indices) : supernodal(supernodal), indices(indices) {}
    using LinearSolver::analyze;
    void analyze(const BlockMatrix& matrix, const std::vector<Index>& order) override {
        of_vertices = order.empty() ? elimination_order(matrix) : order;
        wide.reset();
        if (indices == Indices::as_needed && narrow.emplace(supernodal).analyze(matrix, of_vertices)) return;
        narrow.reset();
        if (!wide.emplace(supernodal).analyze(matrix, of_vertices))
            throw std::runtime_error(
                "linear solver: the factor of the matrix is too large; a coarser mesh or explicit steps need "
                "less");
    }
    std::vector<Index> order() const override { return of_vertices; }
    bool factorize(const BlockMatrix& matrix) override {
        return narrow ? narrow->factorize(matrix) : wide->factorize(matrix);
    }
    VectorXd solve(const VectorXd& right_side) override {
        return narrow ? narrow->solve(right_side) : wide->solve(right_side);
    }
    FactorCost cost() const override {
        const double operations = narrow ? narrow->operations() : wide->operations();
        return {operations / operations_per_entry, factor_entries()};
    }
    double factor_entries() const { return narrow ? narrow->entries() : wide->entries(); }

  private:
    bool supernodal;
    Indices indices;
    std::vector<Index> of_vertices;  ///< elimination order of the vertices
    // The factor is in `narrow` or in `wide`.
    std::optional<CholmodFactor<int>> narrow;
    std::optional<CholmodFactor<SuiteSparse_long>> wide;
};

}  // namespace

std::unique_ptr<LinearSolver> cholesky_solver(Indices indices) {
    return std::make_unique<CholeskySolver>(true, indices);
}

std::unique_ptr<LinearSolver> indefinite_solver() {
    return std::make_unique<CholeskySolver>(false, Indices::as_needed);
}

double factor_size(const BlockMatrix& matrix) {
    CholeskySolver solver(true, Indices::as_needed);
    solver.analyze(matrix);
    return solver.factor_entries();
}

}  // namespace sherd
