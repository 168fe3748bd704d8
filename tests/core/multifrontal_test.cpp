// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/multifrontal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/solver/linear_solver.h"
#include "core/solver/supernodes.h"
#include "tests/support/small_sheet.h"

namespace sherd {
namespace {

using test::Random;

/// A definite matrix on a grid of side x side vertices, each with its neighbours' neighbours, one of them
/// fixed and one guided.
BlockMatrix on_grid(Index side, Random& random, double smallest = 40) {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index i = 0; i < side * side; ++i)
        for (Index j = 0; j < i; ++j)
            if (std::abs(i / side - j / side) + std::abs(i % side - j % side) <= 2) pairs.emplace_back(i, j);
    std::vector<char> fixed(side * side, 0), guide(side * side, 0);
    fixed[side / 2] = 1;
    guide[side] = 1;
    const Vector3d normal(0.6, 0, 0.8);
    BlockMatrix matrix(side * side, pairs, fixed, guide,
                       {Matrix3d::Identity() - normal * normal.transpose()});
    for (const auto& [i, j] : pairs) matrix.add(i, j, random.matrix<Matrix3d>(1));
    for (Index i = 0; i < side * side; ++i) matrix.add(i, i, smallest * Matrix3d::Identity());
    return matrix;
}

template <class Real>
double error_of(const BlockMatrix& matrix, Random& random) {
    MultifrontalFactor<Real> factor(std::make_shared<const Supernodes>(supernodes(matrix)));
    EXPECT_TRUE(factor.factorize(matrix));
    VectorXd right(matrix.size());
    for (double& entry : right) entry = random.uniform(-1, 1);
    const VectorXd reference = test::dense(matrix).llt().solve(right);
    return (factor.solve(right) - reference).norm() / reference.norm();
}

// A row of a front in the wrong place, or a child that is added twice, gives another solution. The larger
// grids have supernodes of many columns and separators of several levels.
TEST(Multifrontal, SolvesLikeADenseSolver) {
    Random random(1);
    for (const Index side : {2, 5, 12, 34}) {
        const BlockMatrix matrix = on_grid(side, random);
        EXPECT_LT(error_of<double>(matrix, random), 1e-13) << side;
        EXPECT_LT(error_of<float>(matrix, random), 1e-5) << side;
    }
}

// What it left behind of the last matrix would show in the next one.
TEST(Multifrontal, FactorsOneMatrixAfterTheOther) {
    Random random(2);
    const BlockMatrix first = on_grid(12, random), second = on_grid(12, random);
    MultifrontalFactor<double> twice(std::make_shared<const Supernodes>(supernodes(first)));
    MultifrontalFactor<double> once(std::make_shared<const Supernodes>(supernodes(second)));
    ASSERT_TRUE(twice.factorize(first));
    ASSERT_TRUE(twice.factorize(second));
    ASSERT_TRUE(once.factorize(second));
    const VectorXd right = VectorXd::LinSpaced(first.size(), -1, 1);
    EXPECT_EQ(twice.solve(right), once.solve(right));
}

TEST(Multifrontal, TellsThatAMatrixIsNotDefinite) {
    Random random(3);
    const BlockMatrix matrix = on_grid(12, random, 1);
    MultifrontalFactor<double> factor(std::make_shared<const Supernodes>(supernodes(matrix)));
    EXPECT_FALSE(factor.factorize(matrix));
}

// Bending against stretching in a thin sheet, beyond what single precision tells from zero: it would be
// taken for indefinite, and steps would creep with the convex matrix.
TEST(SinglePrecisionSolver, TakesDoublePrecisionWhereSingleDoesNotDo) {
    BlockMatrix matrix(2, {{0, 1}}, {0, 0});
    const double stiff = 1, soft = 1e-9;
    matrix.add(0, 0, (stiff + soft) * Matrix3d::Identity());
    matrix.add(1, 1, (stiff + soft) * Matrix3d::Identity());
    matrix.add(1, 0, -stiff * Matrix3d::Identity());
    const std::unique_ptr<LinearSolver> solver = single_precision_solver();
    solver->analyze(matrix);
    ASSERT_TRUE(solver->factorize(matrix));
    const VectorXd right = VectorXd::Ones(6);
    EXPECT_LT((soft * solver->solve(right) - right).norm(), 1e-6);
}

// The method counts on it when it weighs iterations against a factorization.
TEST(SinglePrecisionSolver, AFactorizationCostsMoreTheLargerTheMesh) {
    Random random(4);
    double last = 0;
    for (const Index side : {5, 12, 34}) {
        const std::unique_ptr<LinearSolver> solver = single_precision_solver();
        solver->analyze(on_grid(side, random));
        const double ratio = solver->cost().factorization / solver->cost().solution;
        EXPECT_GT(ratio, last);
        last = ratio;
    }
}

// A vertex that is lost or doubled in the order gives another solution, and one far from its parent a larger
// factor: here a crack has doubled a row of vertices, with new order beside kept order.
TEST(SinglePrecisionSolver, KeepsAnOrderWhereACrackDoublesVertices) {
    Random random(5);
    constexpr Index side = 40, row = 20 * side;
    std::vector<std::pair<Index, Index>> whole, cracked;
    std::vector<Index> parents;
    for (Index x = 0; x < side; ++x) parents.push_back(row + x);
    const auto above = [&](Index v) { return v / side == 20 ? side * side + v % side : v; };
    for (Index i = 0; i < side * side; ++i)
        for (const Index j : {i - 1, i - side, i - side - 1}) {
            if (j < 0 || (j % side) > (i % side)) continue;
            whole.emplace_back(i, j);
            if (i / side <= 20) cracked.emplace_back(i, j);
            if (j / side >= 20) cracked.emplace_back(std::minmax(above(i), above(j)));
        }
    const auto matrix_of = [&](Index vertices, const auto& pairs) {
        BlockMatrix matrix(vertices, pairs, std::vector<char>(vertices, 0));
        for (const auto& [i, j] : pairs) matrix.add(i, j, random.matrix<Matrix3d>(1));
        for (Index i = 0; i < vertices; ++i) matrix.add(i, i, 40 * Matrix3d::Identity());
        return matrix;
    };
    const std::unique_ptr<LinearSolver> solver = single_precision_solver(), anew = single_precision_solver();
    solver->analyze(matrix_of(side * side, whole));
    const BlockMatrix matrix = matrix_of(side * side + side, cracked);
    solver->analyze(matrix, with_children(solver->order(), parents));
    anew->analyze(matrix);
    EXPECT_LT(solver->cost().factorization, 1.5 * anew->cost().factorization);
    ASSERT_TRUE(solver->factorize(matrix));
    ASSERT_TRUE(anew->factorize(matrix));
    const VectorXd right = VectorXd::LinSpaced(matrix.size(), -1, 1);
    EXPECT_LT((solver->solve(right) - anew->solve(right)).norm(), 1e-5 * anew->solve(right).norm());
}

}  // namespace
}  // namespace sherd
