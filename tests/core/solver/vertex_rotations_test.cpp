// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/vertex_rotations.h"

#include <gtest/gtest.h>

#include "tests/support/shell/materials.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

// A factor that is not turned with the sheet does not fit the turned sheet.
TEST(VertexRotations, FollowARigidMotion) {
    test::Random random(1);
    const Shell shell = test::tetrahedron(test::rubber);
    const std::vector<Matrix3d> frames = inverse_frames(shell, shell.position);
    const Matrix3d rotation = random.rotation();
    const Positions moved = (rotation * shell.position).colwise() + random.matrix<Vector3d>(3);
    for (const Matrix3d& turn : vertex_rotations(shell, frames, moved))
        EXPECT_LT((turn - rotation).norm(), 1e-12);
}

TEST(VertexRotations, AreRotationsWhereTheSheetIsStretchedAndSheared) {
    test::Random random(2);
    const Shell shell = test::two_triangles(test::rubber);
    const std::vector<Matrix3d> frames = inverse_frames(shell, shell.position);
    for (int i = 0; i < 50; ++i) {
        const Matrix3d stretch = Matrix3d::Identity() + random.matrix<Matrix3d>(0.3);
        for (const Matrix3d& turn : vertex_rotations(shell, frames, stretch * shell.position)) {
            EXPECT_LT((turn.transpose() * turn - Matrix3d::Identity()).norm(), 1e-9);
            EXPECT_GT(turn.determinant(), 0);
        }
    }
}

// The matrix rows of held vertices belong to fixed directions in space, and must not be turned.
TEST(VertexRotations, LeaveWhatIsHeldAlone) {
    test::Random random(3);
    Shell shell = test::two_triangles(test::rubber);
    shell.fixed[1] = 1;
    shell.guide[2] = 1;
    const std::vector<Matrix3d> turns =
        vertex_rotations(shell, inverse_frames(shell, shell.position), random.rotation() * shell.position);
    EXPECT_EQ(turns[1], Matrix3d::Identity());
    EXPECT_EQ(turns[2], Matrix3d::Identity());
    EXPECT_NE(turns[0], Matrix3d::Identity());
}

}  // namespace
}  // namespace sherd
