// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <utility>

#include "core/solver/linear/linear_solver.h"
#include "core/solver/linear/multifrontal.h"

namespace sherd {
namespace {

class SinglePrecisionSolver : public LinearSolver {
  public:
    explicit SinglePrecisionSolver(Threads threads) : threads(std::move(threads)) {}
    using LinearSolver::analyze;
    void analyze(const BlockMatrix& matrix, const std::vector<Index>& order) override {
        single.reset();
        exact.reset();
        pattern = std::make_shared<const Supernodes>(supernodes(matrix, order));
    }
    std::vector<Index> order() const override { return pattern->order(); }
    bool factorize(const BlockMatrix& matrix) override {
        exact.reset();
        if (!single) single.emplace(pattern, threads);
        if (single->factorize(matrix)) return true;
        if (single->failed_pivot() < surely_negative) return false;
        exact.emplace(pattern, threads);
        return exact->factorize(matrix);
    }
    VectorXd solve(const VectorXd& right_side) override {
        return exact ? exact->solve(right_side) : single->solve(right_side);
    }
    FactorCost cost() const override {
        return {pattern->operations() / operations_per_entry, pattern->factor_entries()};
    }

  private:
    /// Number of operations of a factorization that take as long as one entry of the factor in a solution
    /// (measured: 54 to 67).
    static constexpr double operations_per_entry = 60;

    /// A pivot below this share of its diagonal entry is negative in double precision, too.
    static constexpr double surely_negative = -0.01;

    Threads threads;
    std::shared_ptr<const Supernodes> pattern;
    std::optional<MultifrontalFactor<float>> single;
    std::optional<MultifrontalFactor<double>> exact;  ///< set where single precision does not suffice
};

}  // namespace

std::unique_ptr<LinearSolver> single_precision_solver(Threads threads) {
    return std::make_unique<SinglePrecisionSolver>(std::move(threads));
}

}  // namespace sherd
