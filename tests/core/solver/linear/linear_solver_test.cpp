// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/linear_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

constexpr Index vertex_count = 40;

struct System {
    BlockMatrix sparse;
    Eigen::MatrixXd dense;
};

/// A random definite matrix of blocks, and the same one dense.
System random_system(Random& random, std::vector<char> fixed, double diagonal) {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index i = 0; i < 120; ++i)
        pairs.emplace_back(static_cast<Index>(random.uniform(0, vertex_count)),
                           static_cast<Index>(random.uniform(0, vertex_count)));
    System system{BlockMatrix(vertex_count, pairs, fixed),
                  Eigen::MatrixXd::Zero(3 * vertex_count, 3 * vertex_count)};
    const auto add = [&](Index i, Index j, const Matrix3d& block) {
        system.sparse.add(i, j, block);
        if (fixed[i] || fixed[j]) return;
        system.dense.block<3, 3>(3 * i, 3 * j) += block;
        if (i != j) system.dense.block<3, 3>(3 * j, 3 * i) += block.transpose();
    };
    for (const auto& [i, j] : pairs)
        if (i != j) add(i, j, random.matrix<Matrix3d>(1));
    for (Index i = 0; i < vertex_count; ++i) {
        if (fixed[i]) system.dense.block<3, 3>(3 * i, 3 * i).setIdentity();
        add(i, i, diagonal * Matrix3d::Identity());
    }
    return system;
}

// A block in the wrong place, or the wrong triangle, would give another solution.
TEST(LinearSolver, SolvesLikeADenseSolver) {
    Random random(1);
    std::vector<char> fixed(vertex_count, 0);
    fixed[3] = fixed[17] = 1;
    System system = random_system(random, fixed, 60);
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    solver->analyze(system.sparse);
    ASSERT_TRUE(solver->factorize(system.sparse));
    const VectorXd right = random.matrix<Eigen::Matrix<double, 3 * vertex_count, 1>>(1);
    EXPECT_LT((solver->solve(right) - VectorXd(system.dense.ldlt().solve(right))).norm(),
              1e-12 * right.norm());
}

// A factor with more entries than 32 bits can count is too large for a test; the wide indices are tested
// with a small one.
TEST(LinearSolver, SolvesTheSameWithWideIndices) {
    Random random(3);
    const System system = random_system(random, std::vector<char>(vertex_count, 0), 60);
    const VectorXd right = random.matrix<Eigen::Matrix<double, 3 * vertex_count, 1>>(1);
    const std::unique_ptr<LinearSolver> narrow = cholesky_solver(), wide = cholesky_solver(Indices::wide);
    for (LinearSolver* solver : {narrow.get(), wide.get()}) {
        solver->analyze(system.sparse);
        ASSERT_TRUE(solver->factorize(system.sparse));
    }
    EXPECT_EQ(wide->solve(right), narrow->solve(right));
    EXPECT_EQ(wide->order(), narrow->order());
    EXPECT_EQ(wide->cost().solution, narrow->cost().solution);
}

TEST(LinearSolver, TellsAnIndefiniteMatrixAndGoesOn) {
    Random random(2);
    System definite = random_system(random, std::vector<char>(vertex_count, 0), 60);
    System indefinite = definite;
    indefinite.sparse.add(5, 5, -200 * Matrix3d::Identity());
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    solver->analyze(definite.sparse);
    EXPECT_FALSE(solver->factorize(indefinite.sparse));
    EXPECT_TRUE(solver->factorize(definite.sparse));
}

}  // namespace
}  // namespace sherd
