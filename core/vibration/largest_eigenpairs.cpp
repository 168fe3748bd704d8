// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vibration/largest_eigenpairs.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace sherd {
namespace {

using Eigen::MatrixXd;

constexpr double tolerance = 1e-11;  // largest residual over the eigenvalue
constexpr Eigen::Index max_restarts = 2000;
constexpr Eigen::Index least_basis = 20;   // vectors of a Krylov basis, if the space is so large
constexpr double distinct = 1 + 1e-9;      // ratio from which on eigenvalues count as distinct
constexpr Eigen::Index count_of_more = 4;  // eigenvalues that are computed to see whether one was missed

/// The map within the subspace orthogonal to the columns of `without`, with the interface that Spectra
/// requires.
struct DeflatedMap {
    using Scalar = double;

    const std::function<VectorXd(const VectorXd&)>& map;
    Eigen::Index size;
    const MatrixXd& without;

    Eigen::Index rows() const { return size; }
    Eigen::Index cols() const { return size; }
    VectorXd deflated(VectorXd x) const {
        x -= without * (without.transpose() * x);
        return x;
    }
    void perform_op(const double* in, double* out) const {
        const VectorXd x = Eigen::Map<const VectorXd>(in, size);
        Eigen::Map<VectorXd>(out, size) = deflated(map(deflated(x)));
    }
};

Eigenpairs lanczos(DeflatedMap map, Eigen::Index count) {
    const Eigen::Index basis = std::min(map.size, std::max(2 * count + 1, least_basis));
    Spectra::SymEigsSolver<DeflatedMap> solver(map, count, basis);
    solver.init();  // the start vector is random, with the same seed always
    solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw std::runtime_error(
            "vibration: Lanczos' method does not converge; sherd check warns of implausible materials and "
            "triangles");
    return {solver.eigenvalues(), solver.eigenvectors()};
}

/// The `count` largest eigenpairs of `a` and `b` together, in descending order.
Eigenpairs largest_of(const Eigenpairs& a, const Eigenpairs& b, Eigen::Index count) {
    VectorXd values(a.values.size() + b.values.size());
    values << a.values, b.values;
    MatrixXd vectors(b.vectors.rows(), values.size());
    vectors << a.vectors, b.vectors;
    std::vector<Eigen::Index> order(values.size());
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::ranges::stable_sort(order, std::greater(), [&](Eigen::Index i) { return values[i]; });
    order.resize(std::min<std::size_t>(order.size(), count));
    return {values(order), vectors(Eigen::all, order)};
}

}  // namespace

Eigenpairs largest_eigenpairs(const std::function<VectorXd(const VectorXd&)>& map, Eigen::Index size,
                              const MatrixXd& without, Eigen::Index rank, Eigen::Index count) {
    MatrixXd known = without;
    Eigenpairs found{VectorXd(0), MatrixXd(size, 0)};
    Eigen::Index wanted = count;
    // The Krylov space of a start vector has only one eigenvector of each multiple eigenvalue. The orthogonal
    // complement of the eigenvectors found is therefore searched until it has no larger eigenvalue.
    for (;;) {
        wanted = std::min(wanted, rank + without.cols() - known.cols());
        if (wanted == 0) return found;
        const Eigenpairs more = lanczos({map, size, known}, wanted);
        const bool complete = found.values.size() == count &&
                              more.values[0] <= distinct * found.values[found.values.size() - 1];
        if (complete) return found;
        known.conservativeResize(Eigen::NoChange, known.cols() + more.vectors.cols());
        known.rightCols(more.vectors.cols()) = more.vectors;
        found = largest_of(found, more, count);
        wanted = std::min(count, count_of_more);
    }
}

}  // namespace sherd
