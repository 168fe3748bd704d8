// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/multifrontal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "core/solver/linear/linear_solver.h"
#include "core/solver/linear/supernodes.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

using test::Random;

/// Definite matrix on a grid of side x side vertices, each connected to its two-ring, with one vertex fixed
/// and one guided. smallest: value on the diagonal.
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

// A row of a front in the wrong place, or a child that is added twice, gives a wrong solution. The larger
// grids have supernodes of many columns and separators of several levels.
TEST(Multifrontal, SolvesLikeADenseSolver) {
    Random random(1);
    for (const Index side : {2, 5, 12, 34}) {
        const BlockMatrix matrix = on_grid(side, random);
        EXPECT_LT(error_of<double>(matrix, random), 1e-13) << side;
        EXPECT_LT(error_of<float>(matrix, random), 1e-5) << side;
    }
}

// Entries left behind by the last matrix would falsify the next solution.
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

/// Matrix of several grids that do not touch each other, like loose fragments.
BlockMatrix on_grids(Index side, Index grids, Random& random) {
    std::vector<std::pair<Index, Index>> pairs;
    const Index all = grids * side * side;
    for (Index i = 0; i < all; ++i)
        for (Index j = std::max(0, i - 2 * side); j < i; ++j)
            if (i / (side * side) == j / (side * side) &&
                std::abs(i / side - j / side) + std::abs(i % side - j % side) <= 2)
                pairs.emplace_back(i, j);
    BlockMatrix matrix(all, pairs, std::vector<char>(all, 0));
    for (const auto& [i, j] : pairs) matrix.add(i, j, random.matrix<Matrix3d>(1));
    for (Index i = 0; i < all; ++i) matrix.add(i, i, 40 * Matrix3d::Identity());
    return matrix;
}

// A subtree that takes entries of another subtree, or sums whose order depends on the threads' timing, would
// give other bits or a wrong solution. In the single grid the supernodes above all parts are wider than the
// strips of columns that threads share.
TEST(Multifrontal, HasTheSameBitsWithAnyNumberOfThreads) {
    Random random(6);
    for (const auto& [side, grids] : {std::pair(70, 1), std::pair(20, 12), std::pair(3, 900)}) {
        const BlockMatrix matrix = on_grids(side, grids, random);
        const auto pattern = std::make_shared<const Supernodes>(supernodes(matrix));
        const EliminationParts shares(*pattern);
        EXPECT_GT(shares.parts.size(), 2U) << side;
        EXPECT_EQ(shares.above.empty(), grids > 1) << side;
        MultifrontalFactor<float> alone(pattern), shared(pattern, Threads(2));
        ASSERT_TRUE(alone.factorize(matrix));
        ASSERT_TRUE(shared.factorize(matrix));
        const VectorXd right = VectorXd::LinSpaced(matrix.size(), -1, 1), solution = alone.solve(right);
        EXPECT_EQ(solution, shared.solve(right)) << side;
        const Positions there = solution.reshaped(3, matrix.size() / 3);
        EXPECT_LT((matrix.times(there).reshaped() - right).norm(), 1e-5 * right.norm()) << side;
    }
}

// The failed pivot decides whether double precision is tried: a wrong value costs a factorization each time,
// or gives up the exact Hessian.
TEST(Multifrontal, TellsHowFarFromDefiniteAMatrixIs) {
    Random random(8);
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [diagonal, least, most] :
         {std::tuple(-20.0, -2.0, -0.9), std::tuple(20.0, 1.0, 1.0), std::tuple(none, 0.0, 0.0)}) {
        BlockMatrix matrix = on_grids(30, 1, random);
        MultifrontalFactor<float> factor(std::make_shared<const Supernodes>(supernodes(matrix)));
        EXPECT_TRUE(factor.factorize(matrix));
        EXPECT_EQ(factor.failed_pivot(), 1);
        matrix.add(450, 450, (diagonal - 40) * Matrix3d::Identity());  // the block is now `diagonal` times
                                                                       // the identity
        EXPECT_EQ(factor.factorize(matrix), diagonal == 20);
        EXPECT_GE(factor.failed_pivot(), least);
        EXPECT_LE(factor.failed_pivot(), most);
    }
}

// Each supernode must be eliminated once, after its children; the children of a part's supernode must belong
// to the same part.
TEST(EliminationParts, HaveEachSupernodeOnceWithItsChildren) {
    Random random(7);
    for (const auto& [side, grids] : {std::pair(4, 1), std::pair(50, 1), std::pair(30, 3)}) {
        const Supernodes pattern = supernodes(on_grids(side, grids, random));
        const EliminationParts shares(pattern);
        std::vector<Index> part_of(pattern.size(), -2);
        for (const Index node : shares.above) part_of[node] = -1;
        for (std::size_t p = 0; p < shares.parts.size(); ++p)
            for (Index node = shares.parts[p].first; node < shares.parts[p].end; ++node) {
                EXPECT_EQ(part_of[node], -2);
                part_of[node] = static_cast<Index>(p);
            }
        for (Index node = 0; node < pattern.size(); ++node) {
            EXPECT_NE(part_of[node], -2);
            EXPECT_EQ(shares.is_above[node] != 0, part_of[node] == -1);
            const Index parent = pattern.parent[node];
            if (parent < 0) continue;
            EXPECT_TRUE(part_of[parent] == part_of[node] || part_of[parent] == -1);
            EXPECT_GT(parent, node);
        }
    }
}

TEST(Multifrontal, TellsThatAMatrixIsNotDefinite) {
    Random random(3);
    const BlockMatrix matrix = on_grid(12, random, 1);
    MultifrontalFactor<double> factor(std::make_shared<const Supernodes>(supernodes(matrix)));
    EXPECT_FALSE(factor.factorize(matrix));
}

// Beside the stretching stiffness of a thin sheet, its bending stiffness is too small for single precision:
// the matrix would be taken for indefinite, and the solver would converge slowly with the convex Hessian.
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

// The minimiser uses the ratio of both costs to choose between iterations and a factorization.
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

// A vertex that is lost or doubled in the ordering gives a wrong solution, and a vertex far from its parent a
// larger factor: here a crack has doubled a row of vertices, which are inserted into the old ordering.
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
