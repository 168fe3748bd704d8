// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shell/eigenpairs.h"

#include <Eigen/Eigenvalues>

namespace sherd::test {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
    return Solver(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

Modes modes_of(const Eigen::MatrixXd& stiffness, const VectorXd& mass) {
    const VectorXd root = mass.cwiseSqrt().cwiseInverse();
    const Solver solver(root.asDiagonal() * stiffness * root.asDiagonal());
    return {solver.eigenvalues(), root.asDiagonal() * solver.eigenvectors()};
}

}  // namespace sherd::test
