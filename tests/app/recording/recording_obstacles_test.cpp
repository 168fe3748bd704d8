// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "app/files/image.h"
#include "app/recording/hdf5.h"
#include "app/recording/recording.h"
#include "app/render.h"
#include "meshops/error.h"
#include "tests/support/program.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// A tetrahedron of some 6 cm, named as no path in a file could be.
RecordedObstacle tetrahedron() {
    return {"a/b \"anvil\"",
            {{{0, 0, 0}, {0.06, 0, 0}, {0, 0.06, 0}, {0, 1.0 / 17, 0.06}},
             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}};
}

Eigen::Isometry3d pose(double angle, const Vector3d& place) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.translation() = place;
    return pose;
}

/// Two of them; the second one moves from frame to frame.
std::vector<Eigen::Isometry3d> poses(std::size_t frame) {
    const double k = static_cast<double>(frame);
    return {pose(0.3, {0.02, 0, 0.03}), pose(k, {0.07, 0.01 * k, -0.05})};
}

void record_with_obstacles(const SyntheticRun& run, const fs::path& file) {
    const std::vector<RecordedObstacle> obstacles{tetrahedron(), tetrahedron()};
    RecordingWriter writer(file, run.header, false, obstacles);
    for (std::size_t k = 0; k < run.frames.size(); ++k)
        writer.append(run.frames[k], run.steps[k], run.events[k], poses(k));
    writer.finish(1, "complete");
}

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
    ASSERT_EQ(obstacles.size(), 2u);
    for (const RecordedObstacle& obstacle : obstacles) {
        EXPECT_EQ(obstacle.name, tetrahedron().name);
        EXPECT_EQ(obstacle.surface.points, tetrahedron().surface.points);
        EXPECT_EQ(obstacle.surface.triangles, tetrahedron().surface.triangles);
    }
    ASSERT_EQ(recording.frame_count(), 3u);
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const auto found = recording.poses(frame), expected = poses(frame);
        ASSERT_EQ(found.size(), 2u);
        for (int i = 0; i < 2; ++i) EXPECT_EQ(found[i].matrix(), expected[i].matrix());
    }
}

// Recordings of before there were any, and of scenes without.
TEST(RecordedObstacles, AreNoneWhereNothingIsSaidOfThem) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    EXPECT_FALSE(hdf5::contains(hdf5::open_to_read(folder.path / "run.h5"), "obstacles"));
    const Recording recording(folder.path / "run.h5");
    EXPECT_TRUE(recording.obstacles().empty());
    EXPECT_TRUE(recording.poses(0).empty());
}

// Whoever draws them would read beyond the end of an array.
TEST(RecordedObstacles, ThatAreDamagedAreRefused) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record_with_obstacles(synthetic_run(), file);
    EXPECT_EQ(damage(Recording(file)), "");
    {
        const hdf5::Handle opened = hdf5::open_to_write(file);
        hdf5::remove(opened, "frames/000001/obstacle/pose");
        const std::vector<std::array<double, 12>> one(1);
        hdf5::write<std::array<double, 12>>(opened, "frames/000001/obstacle/pose", one, {});
    }
    EXPECT_NE(damage(Recording(file)).find("frame 1 has 1 poses of 2 obstacles"), std::string::npos);
    {
        const hdf5::Handle opened = hdf5::open_to_write(file);
        hdf5::remove(opened, "obstacles/1/face");
        const std::vector<std::array<Index, 3>> wrong{{0, 1, 4}};
        hdf5::write<std::array<Index, 3>>(opened, "obstacles/1/face", wrong, {});
    }
    EXPECT_NE(damage(Recording(file)).find("anvil"), std::string::npos) << damage(Recording(file));
}

/// A sheet that falls, with a box that moves by keys and a free ball away from it.
const std::string three = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.02 }
[sheet.plate.material]
preset = "glass"
thickness = 0.002
[obstacle.floor]
plane = { point = [0, 0, -1] }
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

// A pose that belongs to another obstacle, or to another time, would draw them where nothing is hit.
TEST(RecordedObstacles, OfARunStandWhereTheyAre) {
    const TemporaryDirectory folder;
    folder.write("scene.toml", three);
    const ProgramResult result = run_sherd({"run", "scene.toml", "-o", "run.h5"}, folder.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Recording recording(folder.path / "run.h5");
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    ASSERT_EQ(obstacles.size(), 2u);
    EXPECT_EQ(obstacles[0].name, "ram");
    EXPECT_EQ(obstacles[1].name, "ball");
    const auto middle = [&](std::size_t frame, std::size_t i) {
        const Eigen::Isometry3d pose = recording.poses(frame)[i];
        Eigen::AlignedBox3d box;
        for (const Vector3d& point : obstacles[i].surface.points) box.extend(pose * point);
        return Vector3d(box.center());
    };
    EXPECT_LT((middle(0, 0) - Vector3d(0, 0, 0.5)).norm(), 1e-12);
    EXPECT_LT((middle(2, 0) - Vector3d(0, 0, 0.51)).norm(), 1e-12);
    EXPECT_LT((middle(0, 1) - Vector3d(0.3, 0.1, 0.2)).norm(), 1e-12);
    EXPECT_LT((middle(2, 1) - Vector3d(0.3, 0.1, 0.196)).norm(), 5e-5);
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
