// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/vector.h"

namespace sherd {

/// Orthonormal eigenvectors, one column each, and their eigenvalues in descending order.
struct Eigenpairs {
    VectorXd values;          ///< [n]
    Eigen::MatrixXd vectors;  ///< [size, n]
};

/// The `count` largest eigenvalues of a symmetric positive semidefinite map of vectors of `size`, in the
/// subspace orthogonal to the orthonormal columns of `without` [size, m]. The subspace must be invariant
/// under the map. rank: number of eigenvalues above zero in the subspace, at least `count`. Eigenvalues that
/// occur several times are found as many times. Spectra's implicitly restarted Lanczos method, from the same
/// start vector each time. Throws std::runtime_error when it does not converge.
Eigenpairs largest_eigenpairs(const std::function<VectorXd(const VectorXd&)>& map, Eigen::Index size,
                              const Eigen::MatrixXd& without, Eigen::Index rank, Eigen::Index count);

}  // namespace sherd
