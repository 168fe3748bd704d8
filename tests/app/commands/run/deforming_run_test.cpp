// SPDX-License-Identifier: GPL-3.0-or-later
// A run with a deforming obstacle, through the real program: in recordings, playback, exports and resumed
// runs the obstacle must have the cache's shape.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/export/export.h"
#include "app/playback/playback.h"
#include "app/recording/recording.h"
#include "app/render/render_stage.h"
#include "app/view/view_data.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/program/base64.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/glb_content.h"
#include "tests/support/recording/point_caches.h"
#include "tests/support/recording/same_report.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Points of a flap of two triangles, hinged along y, that turns up below a plate: by a quarter turn in 0.1
/// s.
Positions hinged_flap(double time) {
    const double angle = 0.5 * 3.14159265 * time / 0.1;
    Positions points(3, 4);
    points << -0.1, -0.1, -0.1 + 0.2 * std::cos(angle), -0.1 + 0.2 * std::cos(angle), -0.1, 0.1, 0.1, -0.1, 0,
        0, 0.2 * std::sin(angle), 0.2 * std::sin(angle);
    return points;
}

const std::string deforming_scene = R"(duration = 0.02
[sheet.plate]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, 0.004] }
material = { density = 1000, thickness = 2e-3, young = 1e7, poisson = 0.4 }
[obstacle.flap]
mesh = "flap.obj"
cache = { file = "flap.pc2", fps = 100, interpolation = "linear" }
friction = 0.3
[solver]
step = 1e-3
[output]
every = 4e-3
)";

class DeformingRun : public ::testing::Test {
  protected:
    DeformingRun() {
        std::vector<Positions> samples;
        for (int i = 0; i <= 10; ++i) samples.push_back(hinged_flap(0.01 * i));
        folder.write("flap.obj", "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nf 1 4 3\nf 1 3 2\n");
        folder.write("flap.pc2", pc2_of(samples));
        folder.write("scene.toml", deforming_scene);
    }
    void run(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"run", "scene.toml"});
        const ProgramResult result = run_sherd(more, folder.path);
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    /// Points of the flap at `time`, s, linear between the samples of the cache.
    static Positions expected(double time) {
        const double before = std::floor(time / 0.01 + 1e-9) * 0.01, share = (time - before) / 0.01;
        return hinged_flap(before) + share * (hinged_flap(before + 0.01) - hinged_flap(before));
    }
    static void expect_at(const std::vector<Vector3d>& points, double time) {
        ASSERT_EQ(points.size(), 4u);
        for (int i = 0; i < 4; ++i)
            EXPECT_LT((points[i] - expected(time).col(i)).norm(), 1e-7) << "point " << i << " at " << time;
    }
    ExportOptions options(const std::string& format, const std::string& output) const {
        ExportOptions wanted;
        wanted.recording = folder.path / "scene.h5";
        wanted.format = format;
        wanted.output = folder.path / output;
        wanted.frames = "all";
        return wanted;
    }

    TemporaryDirectory folder;
};

TEST_F(DeformingRun, IsRecordedFrameByFrame) {
    run();
    const Recording recording(folder.path / "scene.h5");
    const RecordedObstacle obstacle = recording.obstacles().at(0);
    EXPECT_TRUE(obstacle.deforms);
    EXPECT_EQ(obstacle.surface.triangles.size(), 2u);
    ASSERT_EQ(recording.frame_count(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        expect_at(recording.shapes(i).at(0), 0.004 * i);
        EXPECT_TRUE(recording.poses(i).at(0).matrix().isIdentity(0));
    }
    const std::vector<Vector3d> between = ObstaclePlayback(recording).shapes({1, 2, 0.5, 0.006})[0];
    expect_at(between, 0.006);
    EXPECT_NE(folder.contents().at(folder.path / "scene.xdmf").find("frames/000003/obstacle/0/position"),
              std::string::npos);
}

// The flap throws the plate up, and the energy balance must include the flap's work.
TEST_F(DeformingRun, PushesWhatItMeets) {
    for (const char* scheme : {"implicit-euler", "explicit", "auto"}) {
        run({"--force", "--set", std::string("solver.scheme=") + scheme});
        const Recording recording(folder.path / "scene.h5");
        const StepReport last = recording.steps().back();
        EXPECT_GT(last.work_of_obstacles, 1e-3) << scheme;
        EXPECT_LT(std::abs(last.unexplained), 1e-4 * last.work_of_obstacles) << scheme;
        const Snapshot frame = recording.frame(5);
        EXPECT_GT(frame.velocity.row(2).mean(), 0.5) << scheme;
        double largest = 0;
        for (const StepReport& step : recording.steps())
            largest = std::max(largest, step.reactions.at(0).force.z());
        EXPECT_GT(largest, 1) << scheme << ": the force on the plate, N";
    }
}

TEST_F(DeformingRun, GoesOnWithTheSameBits) {
    run({"-o", "whole.h5"});
    run({"-o", "half.h5", "--until", "0.0095"});
    run({"-o", "half.h5", "--resume", "--threads", "2"});
    const Recording whole(folder.path / "whole.h5"), half(folder.path / "half.h5");
    const std::vector<StepReport> steps = whole.steps(), others = half.steps();
    ASSERT_EQ(steps.size(), others.size());
    for (std::size_t i = 0; i < steps.size(); ++i) expect_same(steps[i], others[i]);
    ASSERT_EQ(whole.frame_count(), half.frame_count());
    for (std::size_t i = 0; i < whole.frame_count(); ++i) {
        EXPECT_EQ(whole.frame(i).position, half.frame(i).position);
        EXPECT_EQ(whole.shapes(i), half.shapes(i));
    }
    folder.write("flap.pc2", pc2_of({hinged_flap(0), hinged_flap(0.03)}));
    const ProgramResult other = run_sherd({"run", "scene.toml", "-o", "half.h5", "--resume"}, folder.path);
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("flap.pc2' has changed"), std::string::npos) << other.err;
}

TEST_F(DeformingRun, IsExportedAsItStands) {
    run();
    export_recording(options("ply", "out.ply"));
    for (int i = 0; i < 6; ++i) {
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(folder.path / ("out_00000" + std::to_string(i) + "_obstacle_flap.ply"),
                                    {.join_advice = ""}, warnings);
        std::vector<Vector3d> points;
        for (const Vertex v : mesh.vertices()) points.push_back(position(mesh, v));
        expect_at(points, 0.004 * i);
    }
    export_recording(options("pc2", "out.pc2"));
    EXPECT_TRUE(folder.contents().contains(folder.path / "out_obstacle_flap.pc2"));
}

TEST_F(DeformingRun, HasAShapeForEachFrameInGlb) {
    run();
    export_recording(options("glb", "out.glb"));
    const Glb glb(folder.contents().at(folder.path / "out.glb"));
    const auto& meshes = glb.json["meshes"];
    bool found = false;
    for (const auto& node : glb.json["nodes"])
        if (node["name"] == "obstacle_flap") {
            found = true;
            EXPECT_EQ(meshes[node["mesh"].get<int>()]["primitives"][0]["targets"].size(), 5u);
        }
    EXPECT_TRUE(found);
}

TEST_F(DeformingRun, IsInThePage) {
    run();
    const Recording recording(folder.path / "scene.h5");
    std::vector<std::string> warnings;
    const RenderStage stage(recording, {}, warnings);
    const nlohmann::json page = view_data(recording, stage, {0, 3, 5});
    const std::vector<float> points = decoded<float>(page["frames"][1]["shapes"][0]);
    ASSERT_EQ(points.size(), 12u);
    EXPECT_NEAR(points[8], expected(0.012)(2, 2), 1e-7);
}

// Pictures of two frames must show the flap in two shapes.
TEST_F(DeformingRun, IsDrawnAsItStands) {
    run();
    const Recording recording(folder.path / "scene.h5");
    std::vector<std::string> warnings;
    const RenderStage stage(recording, {}, warnings);
    const auto drawn = [&](std::size_t frame) {
        const RenderScene scene =
            stage.scene(recording.frame(frame), recording.poses(frame), recording.shapes(frame));
        return (scene.meshes.at(1).vertices.at(1).position.cast<double>() + stage.centre()).eval();
    };
    const Vector3d at_start = drawn(0), at_end = drawn(5);
    EXPECT_LT(std::min((at_start - expected(0).col(3)).norm(), (at_start - expected(0).col(2)).norm()), 1e-6);
    EXPECT_LT(std::min((at_end - expected(0.02).col(3)).norm(), (at_end - expected(0.02).col(2)).norm()),
              1e-6);
}

}  // namespace
}  // namespace sherd::test
