// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/vector.h"

namespace sherd::test {

// Eigen's solver takes seconds to compile for each size of matrix: these functions are compiled once.

/// Eigenvalues of a symmetric matrix, ascending.
VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// Vibration modes of a symmetric stiffness K and a diagonal mass M, slowest first: a square w^2 of an
/// angular frequency and a vector u (a column) for each, with K u = w^2 M u and u^T M u = 1.
struct Modes {
    VectorXd squares;
    Eigen::MatrixXd vectors;
};
Modes modes_of(const Eigen::MatrixXd& stiffness, const VectorXd& mass);

}  // namespace sherd::test
