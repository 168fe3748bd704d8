// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/gauge.h"

#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

// A gauge must show the motion of its own point, not of the nearest vertex.
TEST(Gauge, ShowsTheDisplacementOfItsPoint) {
    Shell shell = test::two_triangles(Material{});
    const TrianglePositions rest = columns(shell.rest, shell.triangles[1].vertices);
    const Vector3d place = rest * Vector3d(0.2, 0.3, 0.5);
    const Vector3d normal =
        Vector3d(rest.col(1) - rest.col(0)).cross(Vector3d(rest.col(2) - rest.col(0))).normalized();
    const Gauge gauge = nearest_gauge(shell, place + 0.01 * normal, -1);
    EXPECT_EQ(gauge.face, 1);
    EXPECT_LT((gauge.place - place).norm(), 1e-12);
    Matrix3d map;  // an affine motion, for which interpolation is exact
    map << 1.1, 0.2, 0, -0.1, 0.9, 0.3, 0.4, 0, 1;
    const Vector3d way(1, -2, 3);
    shell.position = (map * shell.rest).colwise() + way;
    EXPECT_LT((reading(shell, gauge).displacement - (map * place + way - place)).norm(), 1e-12);
}

TEST(Gauge, IsSoughtOnItsSheet) {
    Shell shell = test::two_triangles(Material{});
    shell.face_sheet = {0, 1};
    const Vector3d corner = columns(shell.rest, shell.triangles[1].vertices) * Vector3d(0.3, 0.3, 0.4);
    EXPECT_EQ(nearest_gauge(shell, corner, -1).face, 1);
    EXPECT_EQ(nearest_gauge(shell, corner, 0).face, 0);
}

// When a crack splits the face, the gauge must remain on the part with its point.
TEST(Gauge, FollowsItsMaterialWhenAFaceIsSplit) {
    for (const double place : {0.2, 0.8}) {
        Shell shell = test::two_triangles(Material{});
        shell.face_mass = {1, 1};
        shell.face_sheet = {0, 0};
        const std::array<Index, 3> v = shell.triangles[0].vertices;
        const TrianglePositions rest = columns(shell.rest, v);
        const Vector3d at = rest * Vector3d(0.9 * (1 - place), 0.9 * place, 0.1);
        std::vector<Gauge> gauges{nearest_gauge(shell, at, -1)};
        ASSERT_EQ(gauges[0].face, 0);
        // A vertex in the middle of the first side; the face keeps the half with its first corner.
        const ShellChange change{.vertices = {{4, {{v[0], 0.5}, {v[1], 0.5}}}}, .faces = {{2, {{0, 1}}}}};
        follow(shell, change);
        shell.triangles[0].vertices = {v[0], 4, v[2]};
        shell.triangles[2].vertices = {4, v[1], v[2]};
        follow(shell, change, gauges);
        EXPECT_EQ(gauges[0].face, place < 0.5 ? 0 : 2);
        shell.position.col(4) += Vector3d(0, 0, 1);
        const double share = 1.8 * std::min(place, 1 - place);
        EXPECT_NEAR(reading(shell, gauges[0]).displacement.z(), share, 1e-12);
    }
}

}  // namespace
}  // namespace sherd
