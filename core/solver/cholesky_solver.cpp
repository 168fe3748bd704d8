// SPDX-License-Identifier: GPL-3.0-or-later
#include <cblas.h>
#include <cholmod.h>

#include <stdexcept>
#include <string>

#include "core/solver/factor_size.h"
#include "core/solver/linear_solver.h"

// Declared here because OpenMP's header belongs to one compiler's runtime, and CHOLMOD may use another. The
// function exists since OpenMP 3.0.
extern "C" void omp_set_max_active_levels(int levels);

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

class CholeskySolver : public LinearSolver {
  public:
    /// supernodal: L L^T, of positive definite matrices; else L D L^T.
    explicit CholeskySolver(bool supernodal) {
        // CHOLMOD asks for OpenMP teams by number, which slows its supernodal code two to three times on
        // small machines; allowing no active parallel region is the one setting it cannot override.
        omp_set_max_active_levels(0);
        openblas_set_num_threads(1);
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        common.quick_return_if_not_posdef = 1;
        common.nmethods = 1;
    }
    ~CholeskySolver() override {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work1, &common);
        cholmod_free_dense(&work2, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    CholeskySolver(const CholeskySolver&) = delete;
    void analyze(const BlockMatrix& matrix) override;
    bool factorize(const BlockMatrix& matrix) override;
    VectorXd solve(const VectorXd& right_side) override;
    double factor_entries() const { return common.lnz; }

  private:
    void require(bool success, const char* action) const {
        if (!success)
            throw std::runtime_error(std::string("linear solver: cannot ") + action + " (CHOLMOD status " +
                                     std::to_string(common.status) + ")");
    }

    cholmod_common common;
    cholmod_factor* factor = nullptr;
    cholmod_dense *solution = nullptr, *work1 = nullptr, *work2 = nullptr;
};

void CholeskySolver::analyze(const BlockMatrix& matrix) {
    cholmod_sparse sparse = view(matrix);
    cholmod_free_factor(&factor, &common);
    common.method[0].ordering = matrix.size() < nested_dissection_from ? CHOLMOD_AMD : CHOLMOD_METIS;
    factor = cholmod_analyze(&sparse, &common);
    require(factor != nullptr, "analyze the matrix");
}

bool CholeskySolver::factorize(const BlockMatrix& matrix) {
    cholmod_sparse sparse = view(matrix);
    const bool success = cholmod_factorize(&sparse, factor, &common);
    if (common.status == CHOLMOD_NOT_POSDEF) return false;
    require(success, "factorize the matrix");
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
        cholmod_solve2(CHOLMOD_A, factor, &dense, nullptr, &solution, nullptr, &work1, &work2, &common);
    require(success, "solve");
    return Eigen::Map<const VectorXd>(static_cast<const double*>(solution->x), right_side.size());
}

}  // namespace

std::unique_ptr<LinearSolver> cholesky_solver() {
    return std::make_unique<CholeskySolver>(true);
}

std::unique_ptr<LinearSolver> indefinite_solver() {
    return std::make_unique<CholeskySolver>(false);
}

double factor_size(const BlockMatrix& matrix) {
    CholeskySolver solver(true);
    solver.analyze(matrix);
    return solver.factor_entries();
}

}  // namespace sherd
