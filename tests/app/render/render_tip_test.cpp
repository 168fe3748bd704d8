// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of crack tips in pictures: at their place, in the colour of their load.
#include "app/render/render_tip.h"

#include <gtest/gtest.h>

#include "app/render/render_stage.h"
#include "app/render/trace/render_light.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

TEST(RenderTip, IsABallThatPointsAlongItsDirection) {
    const TipMark mark{.place = {1, 2, 3},
                       .direction = Vector3d(1, 2, 2) / 3,
                       .radius = 0.1,
                       .reach = 0.4,
                       .colour = {0.2f, 0.4f, 0.6f}};
    const RenderMesh mesh = tip_marks({mark}, Vector3d(0, 0, 1));
    ASSERT_FALSE(mesh.triangles.empty());
    double ahead = 0, behind = 0, away = 0;
    for (const RenderVertex& vertex : mesh.vertices) {
        const Vector3d way = vertex.position.cast<double>() - Vector3d(1, 2, 2);
        const double along = way.dot(mark.direction);
        ahead = std::max(ahead, along);
        behind = std::max(behind, -along);
        away = std::max(away, (way - along * mark.direction).norm());
        EXPECT_NEAR(vertex.normal.norm(), 1, 1e-5);
        EXPECT_EQ(vertex.colour, mark.colour);
    }
    EXPECT_NEAR(ahead, 0.4, 1e-5);
    EXPECT_NEAR(behind, 0.1, 1e-5);
    EXPECT_NEAR(away, 0.1, 1e-5);
    for (const auto& [a, b, c] : mesh.triangles) {
        const RenderVertex &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const Eigen::Vector3f across = (q.position - p.position).cross(r.position - p.position);
        EXPECT_GE(across.dot(p.normal + q.normal + r.normal), -1e-9f) << "the outside is outside";
    }
    EXPECT_TRUE(tip_marks({}, Vector3d::Zero()).vertices.empty());
}

/// Test with a recording of the synthetic run with two tips.
class RenderTips : public ::testing::Test {
  protected:
    RenderTips() : run(synthetic_run()) {
        add_tips(run);
        record(run, folder.path / "run.h5");
        options.colour = RenderColour::tips;
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::vector<std::string> warnings;
    StageOptions options;
};

TEST_F(RenderTips, StandWhereTheyAreInTheColourOfWhatTheyBear) {
    const Recording recording(folder.path / "run.h5");
    const RenderStage stage(recording, options, warnings);
    EXPECT_EQ(stage.legend(), "G / G_c of tips: 0 (dark violet) to 2 (yellow)");
    ASSERT_TRUE(stage.colour_bar());
    EXPECT_EQ(stage.colour_bar()->title, "G / G_c of tips");
    const RenderMesh marks = stage.scene(recording.frame(1), {}, {}).meshes.back();
    Eigen::AlignedBox3d box;
    for (const RenderVertex& vertex : marks.vertices) box.extend(vertex.position.cast<double>());
    const Vector3d first = Vector3d(0.05, 0.01, -0.02) - stage.centre();
    EXPECT_TRUE(box.contains(first));
    EXPECT_TRUE(box.contains(first + Vector3d(0, 0.02, 0)));
    EXPECT_EQ(marks.vertices.front().colour, linear_colour(map_colour(0.25))) << "G is half of G_c";
    EXPECT_EQ(marks.vertices.back().colour, linear_colour(map_colour(0.5))) << "G is G_c";
    EXPECT_TRUE(stage.scene(recording.frame(0), {}, {}).meshes.back().vertices.empty()) << "none yet";
}

// Without an error, a user would take a picture without tips for a run in which no crack propagates.
TEST_F(RenderTips, AreAnErrorWhereThereAreNone) {
    record(synthetic_run(), folder.path / "none.h5");
    const Recording recording(folder.path / "none.h5");
    try {
        const RenderStage stage(recording, options, warnings);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, Fault::input);
        const std::string what = error.what();
        EXPECT_NE(what.find("--color tips"), std::string::npos) << what;
        EXPECT_NE(what.find("fracture.toughness"), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace sherd::test
