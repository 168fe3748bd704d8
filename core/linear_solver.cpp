// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear_solver.h"

#include <cblas.h>
#include <cholmod.h>

#include <stdexcept>
#include <string>

// From OpenMP 3.0; its header comes with one compiler's own runtime, CHOLMOD's may be another's.
extern "C" void omp_set_max_active_levels(int levels);

namespace sherd {
namespace {

/// Below this many unknowns minimum degree orders as well as nested dissection, and faster.
constexpr Index nested_dissection_from = 3000;

/// CHOLMOD reads the arrays of the matrix where they are.
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

}  // namespace

struct LinearSolver::State {
    cholmod_common common;
    cholmod_factor* factor = nullptr;
    cholmod_dense *solution = nullptr, *work1 = nullptr, *work2 = nullptr;

    State() {
        // CHOLMOD asks for OpenMP teams by number, which slows its supernodal code two to three times on
        // small machines; allowing no active parallel region is the one setting it cannot override.
        omp_set_max_active_levels(0);
        openblas_set_num_threads(1);
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.quick_return_if_not_posdef = 1;
        common.nmethods = 1;
    }
    ~State() {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work1, &common);
        cholmod_free_dense(&work2, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    void require(bool success, const char* action) const {
        if (!success)
            throw std::runtime_error(std::string("linear solver: cannot ") + action + " (CHOLMOD status " +
                                     std::to_string(common.status) + ")");
    }
};

LinearSolver::LinearSolver() : state(std::make_unique<State>()) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::analyze(const BlockMatrix& matrix) {
    cholmod_sparse sparse = view(matrix);
    cholmod_free_factor(&state->factor, &state->common);
    state->common.method[0].ordering = matrix.size() < nested_dissection_from ? CHOLMOD_AMD : CHOLMOD_METIS;
    state->factor = cholmod_analyze(&sparse, &state->common);
    state->require(state->factor != nullptr, "analyze the matrix");
}

bool LinearSolver::factorize(const BlockMatrix& matrix) {
    cholmod_sparse sparse = view(matrix);
    const bool success = cholmod_factorize(&sparse, state->factor, &state->common);
    if (state->common.status == CHOLMOD_NOT_POSDEF) return false;
    state->require(success, "factorize the matrix");
    return state->factor->minor == state->factor->n;
}

VectorXd LinearSolver::solve(const VectorXd& right_side) {
    cholmod_dense dense{};
    dense.nrow = dense.nzmax = dense.d = static_cast<std::size_t>(right_side.size());
    dense.ncol = 1;
    dense.x = const_cast<double*>(right_side.data());
    dense.xtype = CHOLMOD_REAL;
    dense.dtype = CHOLMOD_DOUBLE;
    const bool success = cholmod_solve2(CHOLMOD_A, state->factor, &dense, nullptr, &state->solution, nullptr,
                                        &state->work1, &state->work2, &state->common);
    state->require(success, "solve");
    return Eigen::Map<const VectorXd>(static_cast<const double*>(state->solution->x), right_side.size());
}

}  // namespace sherd
