// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/block_columns.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

constexpr Index vertices = 12;

/// Matrix in which vertex 3 is fixed, 5 slides in a plane and 8 along a line.
BlockMatrix restricted_matrix(const std::vector<std::pair<Index, Index>>& pairs) {
    std::vector<char> fixed(vertices, 0), guide(vertices, 0);
    fixed[3] = 1;
    guide[5] = 1;
    guide[8] = 2;
    const Vector3d along = Vector3d(1, 2, -2) / 3;
    const Matrix3d line = along * along.transpose();
    return {vertices, pairs, fixed, guide, {Matrix3d::Identity() - line, line}};
}

/// Symmetric random matrix of an element with `count` vertices.
Eigen::MatrixXd random_element(test::Random& random, std::size_t count) {
    Eigen::MatrixXd local(3 * count, 3 * count);
    for (double& entry : local.reshaped()) entry = random.uniform(-1, 1);
    return local + local.transpose();
}

// A block in the wrong place, or one that a support does not remove, makes a wrong Hessian.
TEST(BlockMatrix, AddsAllBlocksOfAnElementLikeOneByOne) {
    const std::vector<Index> element{0, 2, 3, 5, 6, 8, 9, 11};
    std::vector<std::pair<Index, Index>> pairs{{1, 4}, {7, 2}, {10, 0}, {4, 5}};  // pairs of other vertices
    for (const Index a : element)
        for (const Index b : element) pairs.emplace_back(a, b);
    BlockMatrix at_once = restricted_matrix(pairs), one_by_one = at_once;
    test::Random random(1);
    const Eigen::MatrixXd local = random_element(random, element.size());
    const auto block = [&](std::size_t a, std::size_t b) -> Matrix3d {
        return local.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
    };
    BlockMatrix::Columns(at_once).add_all(element, block);
    for (std::size_t a = 0; a < element.size(); ++a)
        for (std::size_t b = 0; b <= a; ++b)  // blocks below and above the diagonal in turn
            one_by_one.add(element[(a + b) % 2 ? b : a], element[(a + b) % 2 ? a : b],
                           (a + b) % 2 ? block(b, a) : block(a, b));
    EXPECT_EQ(test::dense(at_once), test::dense(one_by_one));

    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(3 * vertices, 3 * vertices), kept = free;
    for (std::size_t a = 0; a < element.size(); ++a)
        for (std::size_t b = 0; b < element.size(); ++b)
            free.block<3, 3>(3 * element[a], 3 * element[b]) = block(a, b);
    kept.setIdentity();
    kept.block<3, 3>(9, 9).setZero();
    const Vector3d along = Vector3d(1, 2, -2) / 3;
    kept.block<3, 3>(15, 15) -= along * along.transpose();
    kept.block<3, 3>(24, 24) = along * along.transpose();
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(3 * vertices, 3 * vertices);
    EXPECT_LT((test::dense(at_once) - kept * free * kept - (identity - kept)).norm(), 1e-14);
}

// CHOLMOD reads ascending rows without repetitions; contact asks which pairs have a block.
TEST(BlockMatrix, HasEachPairOnceInWhateverOrderItIsNamed) {
    const BlockMatrix matrix = restricted_matrix({{7, 1}, {1, 7}, {0, 7}, {7, 1}, {4, 4}, {1, 2}, {9, 1}});
    std::vector<Index> in_column_of_1;
    for (Index k = matrix.columns()[3]; k < matrix.columns()[4]; ++k)
        in_column_of_1.push_back(matrix.rows()[k]);
    EXPECT_EQ(in_column_of_1, (std::vector<Index>{3, 4, 5, 6, 7, 8, 21, 22, 23, 27, 28, 29}));
    EXPECT_EQ(matrix.values().size(), 6 * vertices + 9 * 4);
    for (const auto& [i, j] : {std::pair{1, 7}, {7, 1}, {7, 0}, {9, 1}, {4, 4}, {2, 2}})
        EXPECT_TRUE(matrix.has(i, j)) << i << ' ' << j;
    for (const auto& [i, j] : {std::pair{7, 2}, {11, 1}, {0, 1}, {8, 9}})
        EXPECT_FALSE(matrix.has(i, j)) << i << ' ' << j;
}

/// Random matrix with a block for each pair of vertices whose numbers differ by at most 2; if `some` is not
/// empty, its part for the vertices `some`.
BlockMatrix row_of_vertices(std::span<const Index> some = {}) {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index v = 0; v < vertices; ++v)
        for (Index w = std::max(0, v - 2); w < v; ++w) pairs.emplace_back(v, w);
    std::vector<char> fixed(vertices, 0), guide(vertices, 0);
    fixed[3] = 1;
    guide[5] = 1;
    const std::vector<Matrix3d> guides{Matrix3d(Vector3d(1, 1, 0).asDiagonal())};
    BlockMatrix matrix = some.empty() ? BlockMatrix(vertices, pairs, fixed, guide, guides)
                                      : BlockMatrix::part(some, vertices, pairs, fixed, guide, guides);
    test::Random random(7);
    for (const auto& [v, w] : pairs) matrix.add(v, w, random.matrix<Matrix3d>(1));
    for (Index v = 0; v < vertices; ++v) {
        const Matrix3d block = random.matrix<Matrix3d>(1);
        matrix.add(v, v, block + block.transpose());
    }
    return matrix;
}

Eigen::MatrixXd rows_and_columns(const Eigen::MatrixXd& whole, std::span<const Index> some) {
    std::vector<Index> scalar;
    for (const Index v : some)
        for (Index c = 0; c < 3; ++c) scalar.push_back(3 * v + c);
    return whole(scalar, scalar);
}

// With other rows or columns, the equations of a patch would be those of other vertices.
TEST(BlockMatrix, APartHasItsRowsAndColumnsOfTheWhole) {
    const std::vector<Index> some{1, 2, 3, 5, 6, 9};
    const Eigen::MatrixXd whole = test::dense(row_of_vertices());
    const BlockMatrix part = row_of_vertices(some);
    EXPECT_EQ(test::dense(part), rows_and_columns(whole, some));
    EXPECT_TRUE(part.has_all(std::vector<Index>{1, -1, 9}));
    EXPECT_FALSE(part.has_all(std::vector<Index>{1, 4}));
    const std::vector<Index> fewer{2, 3, 6};
    EXPECT_EQ(test::dense(part.restricted({0, 1, 1, 0, 1, 0})), rows_and_columns(whole, fewer));
}

TEST(BlockMatrix, AddsAllToAPartAndToADiagonal) {
    const std::vector<Index> element{0, 1, 2}, some{1, 2};
    test::Random random(8);
    const Eigen::MatrixXd local = random_element(random, 3);
    const auto block = [&](std::size_t a, std::size_t b) -> Matrix3d {
        return local.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
    };
    const std::vector<std::pair<Index, Index>> pairs{{0, 1}, {0, 2}, {1, 2}};
    BlockMatrix part = BlockMatrix::part(some, 3, pairs, {0, 0, 0}, {0, 0, 0}, {});
    BlockMatrix::Columns(part).add_all(element, block);
    EXPECT_EQ(test::dense(part), local.bottomRightCorner(6, 6));
    BlockMatrix diagonal = BlockMatrix::diagonal(3);
    BlockMatrix::Columns(diagonal).add_all(element, block);
    for (Index v = 0; v < 3; ++v) EXPECT_EQ(diagonal.diagonal_block(v), block(v, v));
}

// A contact may join two vertices of a patch between which the matrix has no block: if its stiffness were
// added to another block, it would be at the wrong place, which another thread may be writing.
TEST(BlockMatrix, APartIgnoresBlocksThatItDoesNotHave) {
    const std::vector<Index> some{1, 2, 3, 5};
    BlockMatrix part = BlockMatrix::part(some, 6, {{1, 2}, {2, 5}, {3, 5}}, std::vector<char>(6, 0), {}, {});
    const Eigen::MatrixXd before = test::dense(part);
    for (const auto& [i, j] : {std::pair{1, 3}, {3, 1}, {1, 5}, {3, 2}}) part.add(i, j, Matrix3d::Ones());
    EXPECT_EQ(test::dense(part), before);
    part.add(5, 2, Matrix3d::Ones());
    EXPECT_EQ(test::dense(part).sum(), before.sum() + 18);
}

std::vector<std::pair<Index, Index>> all_pairs() {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index v = 0; v < vertices; ++v)
        for (Index w = 0; w < v; ++w) pairs.emplace_back(v, w);
    return pairs;
}

std::vector<char> one_fixed() {
    std::vector<char> fixed(vertices, 0);
    fixed[3] = 1;
    return fixed;
}

/// Matrix with all pairs of 12 vertices, with one fixed vertex or with the supports of restricted_matrix().
BlockMatrix full_matrix(bool restricted) {
    if (restricted) return restricted_matrix(all_pairs());
    return {vertices, all_pairs(), one_fixed()};
}

BlockMatrix full_part(const std::vector<Index>& some) {
    return BlockMatrix::part(some, vertices, all_pairs(), one_fixed(), {}, {});
}

// If add_square() wrote to other blocks than add_all(), faces would have the bending stiffness of other
// faces, or none near a support.
TEST(BlockMatrix, AddsTheSquareOfRowsLikeItsBlocks) {
    const std::vector<Index> element{0, 2, 3, 5, 6, 8, 9};
    test::Random random(10);
    BlockMatrix::Columns::Rows rows(3, 3 * element.size());
    for (double& entry : rows.reshaped()) entry = random.uniform(-1, 1);
    const Eigen::MatrixXd product = rows.transpose() * rows;
    const std::vector<Index> with_all{0, 2, 3, 5, 6, 8, 9, 11}, with_some{2, 3, 6, 7, 9};
    for (BlockMatrix square :
         {full_matrix(false), full_matrix(true), full_part(with_all), full_part(with_some)}) {
        BlockMatrix blocks = square;
        BlockMatrix::Columns(square).add_square(element, rows);
        BlockMatrix::Columns(blocks).add_all(element, [&](std::size_t a, std::size_t b) -> Matrix3d {
            return product.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
        });
        EXPECT_LT((test::dense(square) - test::dense(blocks)).norm(), 1e-14) << square.size();
        EXPECT_GT(test::dense(square).norm(), 1.0);
    }
}

/// Sum of 5,000 elements of three neighbouring vertices each; every seventh element is zero. some: the
/// vertices of a part; empty: all vertices.
BlockMatrix shared_sum(int threads, std::span<const Index> some = {}) {
    constexpr Index count = 200;
    std::vector<std::pair<Index, Index>> pairs;
    for (Index v = 0; v < count; ++v)
        for (Index w = std::max(0, v - 2); w < v; ++w) pairs.emplace_back(v, w);
    const std::vector<char> fixed(count, 0);
    BlockMatrix matrix = some.empty() ? BlockMatrix(count, pairs, fixed)
                                      : BlockMatrix::part(some, count, pairs, fixed, {}, {});
    matrix.share_among(Threads(threads));
    using Local = Eigen::Matrix<double, 9, 9>;
    matrix.add_elements<Local>(
        5000,
        [](std::size_t i, Local& local) {
            test::Random random(static_cast<unsigned>(i));
            local = random.matrix<Local>(1);
            local = (local + local.transpose()).eval();
            return i % 7 != 0;
        },
        [&](BlockMatrix::Columns& columns, std::size_t i, const Local& local) {
            const Index v = static_cast<Index>(i) % (count - 2);
            add_element(columns, std::array{v + 1, v + 2, v}, local);
        });
    return matrix;
}

// A Hessian must not depend on the number of cores. An element that is added twice or not at all would change
// the material.
TEST(BlockMatrix, SharedSumsHaveTheSameBits) {
    const std::vector<Index> some{3, 4, 5, 40, 41, 60, 61, 62, 63, 199};
    EXPECT_GT(test::dense(shared_sum(1)).norm(), 100);
    for (const int threads : {2, 3}) {
        EXPECT_EQ(test::dense(shared_sum(threads)), test::dense(shared_sum(1)));
        EXPECT_EQ(test::dense(shared_sum(threads, some)), test::dense(shared_sum(1, some)));
    }
}

TEST(BlockMatrix, TimesPositionsIsTheDenseProduct) {
    const BlockMatrix matrix = row_of_vertices();
    test::Random random(9);
    const Positions x = random.matrix<Eigen::Matrix<double, 3, vertices>>(1);
    const VectorXd product = test::dense(matrix) * VectorXd(x.reshaped());
    EXPECT_LT((VectorXd(matrix.times(x).reshaped()) - product).norm(), 1e-13);
}

}  // namespace
}  // namespace sherd
