// SPDX-License-Identifier: GPL-3.0-or-later
// Other engines continue the motion of fragments from exported velocities and spins: with a wrong spin a body
// would fly apart differently.
#include <Eigen/Geometry>

#include "app/export/fragment_motion.h"
#include "app/json/json.h"
#include "meshops/solid/body_check.h"
#include "tests/support/recording/export_fixture.h"

namespace sherd::test {
namespace {

/// Surfaces of two tetrahedra, the second of which flies and spins.
Snapshot two_rigid_pieces(const Vector3d& velocity, const Vector3d& spin) {
    Snapshot frame;
    frame.position.resize(3, 8);
    frame.velocity = Positions::Zero(3, 8);
    frame.mass.resize(8);
    for (Index v = 0; v < 8; ++v) {
        const int corner = v % 4;
        frame.position.col(v) =
            Vector3d(corner == 1, corner == 2, corner == 3) * 0.3 + Vector3d(v < 4 ? 0 : 1, 0, 1);
        frame.mass[v] = 1 + 0.25 * v;
    }
    for (const Index first : {0, 4})
        for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
            frame.faces.push_back({first + a, first + b, first + c});
            frame.face_fragment.push_back(first / 4);
        }
    for (Index v = 4; v < 8; ++v)
        frame.velocity.col(v) = velocity + spin.cross(Vector3d(frame.position.col(v)));
    return frame;
}

TEST(FragmentMotion, OfARigidMotionIsThatMotion) {
    const Vector3d velocity(1, -2, 3), spin(10, 20, -5);
    const auto all = fragment_motions(two_rigid_pieces(velocity, spin));
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].velocity, Vector3d::Zero());
    EXPECT_EQ(all[0].spin, Vector3d::Zero());
    EXPECT_NEAR(all[1].mass, 2 + 2.25 + 2.5 + 2.75, 1e-12);
    EXPECT_LT((all[1].spin - spin).norm(), 1e-12 * spin.norm());
    EXPECT_LT((all[1].velocity - velocity - spin.cross(all[1].centre)).norm(), 1e-12);
    EXPECT_EQ(all[1].faces, 4);
}

// All mass is in two points, which have no inertia about the line through them: the spin must still be a
// number.
TEST(FragmentMotion, AboutALineThereIsNoSpin) {
    Snapshot frame = two_rigid_pieces({0, 0, 0}, {0, 0, 2});
    frame.mass.tail(2).setZero();
    const auto all = fragment_motions(frame);
    EXPECT_TRUE(all[1].spin.allFinite());
    EXPECT_NEAR(all[1].spin.z(), 2, 1e-9);
}

TEST_F(Export, FragmentsAreATableAndBodies) {
    ExportOptions given = options("fragments", "pieces.csv");
    given.thickness = 0.002;
    const ExportReport report = export_recording(given);
    const Snapshot& last = run.frames.back();
    const auto all = fragment_motions(last);
    ASSERT_EQ(report.files.size(), all.size() + 2);
    const Json table = Json::parse(bytes("pieces.json"));
    ASSERT_EQ(table["fragments"].size(), all.size());
    EXPECT_EQ(table["time"].get<double>(), last.time);
    double mass = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Json& one = table["fragments"][i];
        mass += one["mass"].get<double>();
        EXPECT_EQ(one["spin"][2].get<double>(), all[i].spin.z()) << "a digit is lost";
        EXPECT_TRUE(std::filesystem::exists(folder.path / one["body"].get<std::string>()));
    }
    EXPECT_NEAR(mass, last.mass.sum(), 1e-9 * last.mass.cwiseAbs().sum());
    const std::string csv = bytes("pieces.csv");
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), all.size() + 1);
    EXPECT_EQ(csv.substr(0, 20), "fragment,faces,mass,");
}

}  // namespace
}  // namespace sherd::test
