// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "app/commands/render.h"
#include "app/files/picture/image.h"
#include "app/recording/hdf5.h"
#include "app/recording/hdf5_file.h"
#include "app/recording/recording.h"
#include "app/render/render_stage.h"
#include "meshops/error.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/recorded_obstacles.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

std::string damage(const Recording& recording) {
    try {
        recording.obstacles();
        recording.poses(1);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(RecordedObstacles, KeepEveryBitOfTheirShapesAndPoses) {
    const TemporaryDirectory folder;
    record_with_obstacles(synthetic_run(), folder.path / "run.h5");
    const Recording recording(folder.path / "run.h5");
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    ASSERT_EQ(obstacles.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const RecordedObstacle expected = recorded_obstacles()[i];
        EXPECT_EQ(obstacles[i].name, expected.name);
        EXPECT_EQ(obstacles[i].surface.points, expected.surface.points);
        EXPECT_EQ(obstacles[i].surface.triangles, expected.surface.triangles);
        EXPECT_EQ(obstacles[i].plane, i == 2);
    }
    ASSERT_EQ(recording.frame_count(), 3u);
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const auto found = recording.poses(frame), expected = obstacle_poses(frame);
        ASSERT_EQ(found.size(), 3u);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(found[i].matrix(), expected[i].matrix());
    }
}

// Recordings of old versions, and of scenes without obstacles, must be readable and have none.
TEST(RecordedObstacles, AreNoneWhereNothingIsSaidOfThem) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    EXPECT_FALSE(hdf5::contains(hdf5::ReadableFile(folder.path / "run.h5"), "obstacles"));
    const Recording recording(folder.path / "run.h5");
    EXPECT_TRUE(recording.obstacles().empty());
    EXPECT_TRUE(recording.poses(0).empty());
}

// If damaged obstacles were accepted, drawing them would read beyond the end of an array.
TEST(RecordedObstacles, ThatAreDamagedAreRefused) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record_with_obstacles(synthetic_run(), file);
    EXPECT_EQ(damage(Recording(file)), "");
    {
        const hdf5::Handle opened = open_to_edit(file);
        hdf5::remove(opened, "frames/000001/obstacle/pose");
        const std::vector<std::array<double, 12>> one(1);
        hdf5::write<std::array<double, 12>>(opened, "frames/000001/obstacle/pose", one, {});
    }
    EXPECT_NE(damage(Recording(file)).find("frame 1 has 1 poses of 3 obstacles"), std::string::npos);
    {
        const hdf5::Handle opened = open_to_edit(file);
        hdf5::remove(opened, "obstacles/1/face");
        const std::vector<std::array<Index, 3>> wrong{{0, 1, 4}};
        hdf5::write<std::array<Index, 3>>(opened, "obstacles/1/face", wrong, {});
    }
    EXPECT_NE(damage(Recording(file)).find("anvil"), std::string::npos) << damage(Recording(file));
}

// Recordings of earlier versions do not say which obstacles are planes: then all are solids.
TEST(RecordedObstacles, OfEarlierVersionsAreSolids) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record_with_obstacles(synthetic_run(), file);
    hdf5::remove(open_to_edit(file), "obstacles/plane");
    for (const RecordedObstacle& obstacle : Recording(file).obstacles()) EXPECT_FALSE(obstacle.plane);
    {
        const hdf5::Handle opened = open_to_edit(file);
        const std::vector<std::uint8_t> few{1};
        hdf5::write<std::uint8_t>(opened, "obstacles/plane", few, {});
    }
    EXPECT_NE(damage(Recording(file)).find("obstacles/plane has 1 rows of 3 obstacles"), std::string::npos);
}

/// Scene of a sheet that falls between a floor and a lid, with a box that moves by keys and a free ball, both
/// away from the sheet.
const std::string three = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.02 }
[sheet.plate.material]
preset = "glass"
thickness = 0.002
[obstacle.floor]
plane = { point = [0, 0, -1] }
[obstacle.lid]
plane = { normal = [0, 0, -1] }
place = { translate = [0, 0, 2] }
keys = [{ time = 0 }, { time = 0.002, translate = [0, 0, -0.1] }]
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.3, 0.1, 0.2] }
density = 7850
velocity = [0, 0, -2]
[obstacle.ram]
box = { size = [0.1, 0.1, 0.1], centre = [0, 0, 0] }
place = { translate = [0, 0, 0.5] }
keys = [{ time = 0 }, { time = 0.002, translate = [0, 0, 0.01] }]
[solver]
step = 1e-3
[output]
every = 1e-3
)";

// With poses of other obstacles, or of another time, obstacles would be shown in wrong places.
TEST(RecordedObstacles, OfARunStandWhereTheyAre) {
    const TemporaryDirectory folder;
    folder.write("scene.toml", three);
    const ProgramResult result = run_sherd({"run", "scene.toml", "-o", "run.h5"}, folder.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Recording recording(folder.path / "run.h5");
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    ASSERT_EQ(obstacles.size(), 4u);
    EXPECT_EQ(obstacles[0].name, "floor");
    EXPECT_EQ(obstacles[1].name, "lid");
    EXPECT_EQ(obstacles[2].name, "ram");
    EXPECT_EQ(obstacles[3].name, "ball");
    const auto middle = [&](std::size_t frame, std::size_t i) {
        const Eigen::Isometry3d pose = recording.poses(frame)[i];
        Eigen::AlignedBox3d box;
        for (const Vector3d& point : obstacles[i].surface.points) box.extend(pose * point);
        return Vector3d(box.center());
    };
    EXPECT_LT((middle(0, 2) - Vector3d(0, 0, 0.5)).norm(), 1e-12);
    EXPECT_LT((middle(2, 2) - Vector3d(0, 0, 0.51)).norm(), 1e-12);
    EXPECT_LT((middle(0, 3) - Vector3d(0.3, 0.1, 0.2)).norm(), 1e-12);
    EXPECT_LT((middle(2, 3) - Vector3d(0.3, 0.1, 0.196)).norm(), 5e-5);
}

// A square that faces away, or lies beside the sheets, would show wrong contact in ParaView and Blender.
TEST(RecordedObstacles, ThatArePlanesAreSquaresAroundAllElse) {
    const TemporaryDirectory folder;
    folder.write("scene.toml", three);
    const ProgramResult result = run_sherd({"run", "scene.toml", "-o", "run.h5"}, folder.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Recording recording(folder.path / "run.h5");
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    // Around the sheet, the ram and the ball: x -0.05 to 0.32, y -0.05 to 0.12, z 0 to 0.55.
    const double half = Vector3d(0.37, 0.17, 0.55).norm();
    for (const auto& [i, frame, z, up] :
         {std::tuple{0, 0, -1.0, 1.0}, {0, 2, -1.0, 1.0}, {1, 0, 2.0, -1.0}, {1, 2, 1.9, -1.0}}) {
        EXPECT_TRUE(obstacles[i].plane);
        const Eigen::Isometry3d pose = recording.poses(frame)[i];
        const std::vector<Vector3d>& points = obstacles[i].surface.points;
        ASSERT_EQ(points.size(), 4u);
        for (const Vector3d& point : points) {
            EXPECT_NEAR((pose * point).z(), z, 1e-12);
            EXPECT_NEAR(std::abs((pose * point).x() - 0.135), half, 1e-3);
            EXPECT_NEAR(std::abs((pose * point).y() - 0.035), half, 1e-3);
        }
        for (const auto& [a, b, c] : obstacles[i].surface.triangles) {
            const Vector3d normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
            EXPECT_NEAR((pose.linear() * normal).z(), up, 1e-12) << "to the side of the sheets";
        }
    }
    EXPECT_FALSE(obstacles[2].plane || obstacles[3].plane);
}

// A floor drawn as a square of two triangles would end in the air; a plane that moves must not stand still in
// pictures.
TEST(RecordedObstacles, ThatArePlanesAreTheGroundOfPictures) {
    const TemporaryDirectory folder;
    record_with_obstacles(synthetic_run(), folder.path / "run.h5");
    const Recording recording(folder.path / "run.h5");
    std::vector<std::string> warnings;
    const RenderStage stage(recording, {}, warnings);
    std::vector<Eigen::Isometry3d> poses = recording.poses(2);
    const auto height = [&] {
        const std::vector<RenderPlane> ground = stage.ground(poses);
        EXPECT_EQ(ground.size(), 1u);
        EXPECT_LT((ground[0].normal - Eigen::Vector3f::UnitZ()).norm(), 1e-6F);
        return ground[0].point.z() + stage.centre().z();
    };
    EXPECT_NEAR(height(), -0.1, 1e-6);
    EXPECT_EQ(stage.scene(recording.frame(2), poses, recording.shapes(2)).meshes.size(), 3u)
        << "the sheets and two tetrahedra";
    poses[2].translation().z() = 0.3;
    EXPECT_NEAR(height(), 0.3, 1e-6);
}

TEST(RecordedObstacles, AreInThePicture) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "without.h5");
    record_with_obstacles(synthetic_run(), folder.path / "with.h5");
    const auto grey_pixels = [&](const std::string& name) {
        RenderOptions options;
        options.recording = folder.path / (name + ".h5");
        options.output = folder.path / (name + ".png");
        options.size = "96x54";
        options.samples = 5;
        options.ground = "none";
        render_recording(options);
        const Image image = read_png(options.output);
        int grey = 0;
        for (Eigen::Index i = 0; i < image.colours.cols(); ++i) {
            const Eigen::Vector3f c = image.colours.col(i);
            grey += c.maxCoeff() - c.minCoeff() < 0.08f && c.maxCoeff() < 0.75f;
        }
        return grey;
    };
    EXPECT_GT(grey_pixels("with"), grey_pixels("without") + 100);
}

}  // namespace
}  // namespace sherd::test
