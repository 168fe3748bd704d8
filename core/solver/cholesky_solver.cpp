// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/cholmod_session.h"
#include "core/solver/factor_size.h"
#include "core/solver/linear_solver.h"
#include "core/solver/supernodes.h"

namespace sherd {
namespace {

/// Below this number of unknowns minimum degree orders as well as nested dissection, and faster.
constexpr Index nested_dissection_from = 3000;

/// A CHOLMOD matrix that refers to the arrays of `matrix` without a copy.
cholmod_sparse view(const BlockMatrix& matrix) {
    cholmod_sparse sparse{};
    sparse.nrow = sparse.ncol = static_cast<std::size_t>(matrix.size());
    sparse.nzmax = matrix.values().size();
    sparse.p = const_cast<Index*>(matrix.columns().data());
    sparse.i = const_cast<Index*>(matrix.rows().data());
    sparse.x = const_cast<double*>(matrix.values().data());
    sparse.stype = -1;
    sparse.itype = CHOLMOD_INT;
    sparse.xtype = CHOLMOD_REAL;
    sparse.dtype = CHOLMOD_DOUBLE;
    sparse.sorted = sparse.packed = 1;
    return sparse;
}

/// Operations of a factorization that take as long as an entry in a solution.
constexpr double operations_per_entry = 30;

/// The order of the unknowns when vertices are eliminated in this order.
std::vector<Index> of_unknowns(const std::vector<Index>& vertices) {
    std::vector<Index> order;
    order.reserve(3 * vertices.size());
    for (const Index vertex : vertices)
        for (Index c = 0; c < 3; ++c) order.push_back(3 * vertex + c);
    return order;
}

class CholeskySolver : public LinearSolver {
  public:
    /// supernodal: L L^T, of positive definite matrices; else L D L^T.
    CholeskySolver(bool supernodal, Ordering ordering) : ordering(ordering) {
        session.common.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    }
    ~CholeskySolver() override {
        cholmod_free_dense(&solution, common());
        cholmod_free_dense(&work1, common());
        cholmod_free_dense(&work2, common());
        cholmod_free_factor(&factor, common());
    }
    CholeskySolver(const CholeskySolver&) = delete;
    using LinearSolver::analyze;
    void analyze(const BlockMatrix& matrix, const std::vector<Index>& order) override;
    std::vector<Index> order() const override { return of_vertices; }
    bool factorize(const BlockMatrix& matrix) override;
    VectorXd solve(const VectorXd& right_side) override;
    FactorCost cost() const override {
        return {session.common.fl / operations_per_entry, session.common.lnz};
    }
    double factor_entries() const { return session.common.lnz; }

  private:
    cholmod_common* common() { return &session.common; }

    CholmodSession session;
    Ordering ordering;
    std::vector<Index> of_vertices;  ///< their order, unless unknowns are ordered
    cholmod_factor* factor = nullptr;
    cholmod_dense *solution = nullptr, *work1 = nullptr, *work2 = nullptr;
};

void CholeskySolver::analyze(const BlockMatrix& matrix, const std::vector<Index>& order_of_vertices) {
    cholmod_sparse sparse = view(matrix);
    cholmod_free_factor(&factor, common());
    if (ordering == Ordering::vertices) {
        of_vertices = order_of_vertices.empty() ? elimination_order(matrix) : order_of_vertices;
        std::vector<Index> order = of_unknowns(of_vertices);
        common()->method[0].ordering = CHOLMOD_GIVEN;
        factor = cholmod_analyze_p(&sparse, order.data(), nullptr, 0, common());
    } else {
        common()->method[0].ordering = matrix.size() < nested_dissection_from ? CHOLMOD_AMD : CHOLMOD_METIS;
        factor = cholmod_analyze(&sparse, common());
    }
    session.require(factor != nullptr, "analyze the matrix");
}

bool CholeskySolver::factorize(const BlockMatrix& matrix) {
    cholmod_sparse sparse = view(matrix);
    const bool success = cholmod_factorize(&sparse, factor, common());
    if (common()->status == CHOLMOD_NOT_POSDEF) return false;
    session.require(success, "factorize the matrix");
    return factor->minor == factor->n;
}

VectorXd CholeskySolver::solve(const VectorXd& right_side) {
    cholmod_dense dense{};
    dense.nrow = dense.nzmax = dense.d = static_cast<std::size_t>(right_side.size());
    dense.ncol = 1;
    dense.x = const_cast<double*>(right_side.data());
    dense.xtype = CHOLMOD_REAL;
    dense.dtype = CHOLMOD_DOUBLE;
    const bool success =
        cholmod_solve2(CHOLMOD_A, factor, &dense, nullptr, &solution, nullptr, &work1, &work2, common());
    session.require(success, "solve");
    return Eigen::Map<const VectorXd>(static_cast<const double*>(solution->x), right_side.size());
}

}  // namespace

std::unique_ptr<LinearSolver> cholesky_solver(Ordering ordering) {
    return std::make_unique<CholeskySolver>(true, ordering);
}

std::unique_ptr<LinearSolver> indefinite_solver() {
    return std::make_unique<CholeskySolver>(false, Ordering::vertices);
}

double factor_size(const BlockMatrix& matrix) {
    CholeskySolver solver(true, Ordering::vertices);
    solver.analyze(matrix);
    return solver.factor_entries();
}

}  // namespace sherd
