// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vibration/largest_eigenpairs.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

using Eigen::MatrixXd;

constexpr Eigen::Index size = 200;

/// Eigenvalues: 100 for `copies` times, 95 once, and many from 75 downwards.
VectorXd spectrum(int copies) {
    VectorXd values = VectorXd::LinSpaced(size, 75, 0.1);
    values.head(copies).setConstant(100);
    values[copies] = 95;
    return values;
}

// Lanczos' method alone finds too few of the equal eigenvalues, with 95 in the place of one.
TEST(LargestEigenpairs, AreFoundAsOftenAsTheyAre) {
    for (const int copies : {2, 4}) {
        const VectorXd values = spectrum(copies);
        const auto map = [&](const VectorXd& x) -> VectorXd { return values.cwiseProduct(x); };
        const Eigenpairs found = largest_eigenpairs(map, size, MatrixXd(size, 0), size, copies);
        ASSERT_EQ(found.values.size(), copies);
        EXPECT_LT((found.values.array() - 100).abs().maxCoeff(), 1e-9) << found.values;
        const MatrixXd unit = MatrixXd::Identity(copies, copies);
        EXPECT_LT((found.vectors.transpose() * found.vectors - unit).norm(), 1e-9);
        EXPECT_LT(found.vectors.bottomRows(size - copies).norm(), 1e-6) << "not in the eigenspace";
    }
}

// Rigid motions, which are given as known, must not be found again.
TEST(LargestEigenpairs, LeaveOutWhatIsKnown) {
    const VectorXd values = spectrum(4);
    const auto map = [&](const VectorXd& x) -> VectorXd { return values.cwiseProduct(x); };
    const MatrixXd known = MatrixXd::Identity(size, 3);
    const Eigenpairs found = largest_eigenpairs(map, size, known, size - 3, 2);
    ASSERT_EQ(found.values.size(), 2);
    EXPECT_NEAR(found.values[0], 100, 1e-9);
    EXPECT_NEAR(found.values[1], 95, 1e-9);
    EXPECT_LT((known.transpose() * found.vectors).norm(), 1e-12);
}

// A sheet with few free coordinates has few modes, among many coordinates that are held.
TEST(LargestEigenpairs, EndWhereThereAreNoMore) {
    VectorXd values = VectorXd::Zero(size);
    values.segment<4>(7) << 3, 2, 3, 1;
    const auto map = [&](const VectorXd& x) -> VectorXd { return values.cwiseProduct(x); };
    const Eigenpairs found = largest_eigenpairs(map, size, MatrixXd(size, 0), 4, 4);
    EXPECT_LT((found.values - Eigen::Vector4d(3, 3, 2, 1)).norm(), 1e-9);
}

}  // namespace
}  // namespace sherd
