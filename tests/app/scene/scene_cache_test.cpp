// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacle with a point cache: its vertices must follow the cache, placed and scaled like its mesh, and
// faults must be reported with their line.
#include <gtest/gtest.h>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/plausibility.h"
#include "app/scene/assemble/obstacle/obstacles.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/plate_and_obstacle.h"
#include "tests/support/program/replaced.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/point_caches.h"

namespace sherd::test {
namespace {

const std::string above_cached = replaced(plate_and_obstacle, "0.002", "0.05");
/// Mesh file with a quadrangle, a vertex that no face uses, and a triangle beside the quadrangle.
const std::string cached_mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nv 2 0 0\nf 1 2 3 4\nf 2 6 3\n";

/// Positions of this mesh's vertices: in sample s all vertices of faces are at the height s, m.
std::vector<Positions> raised_samples(int count) {
    std::vector<Positions> all;
    for (int s = 0; s < count; ++s) {
        Positions points(3, 6);
        points << 0, 1, 1, 0, 9, 2, 0, 0, 1, 1, 9, 0, s, s, s, s, 9, s;
        all.push_back(points);
    }
    return all;
}

class SceneCache : public ::testing::Test {
  protected:
    SceneCache() {
        directory.write("hand.obj", cached_mesh);
        directory.write("hand.pc2", pc2_of(raised_samples(3)));
        directory.write("hand.mdd", mdd_of(raised_samples(3), {0, 0.1F, 0.4F}));
    }
    Scene scene(const std::string& obstacle) const {
        return read_scene(directory.write("scene.toml", above_cached + obstacle));
    }
    Obstacle obstacle(const std::string& text) {
        warnings.clear();
        return make_obstacles(scene(text).obstacles, {1e-3, 1e-3}, warnings).at(0);
    }
    void expect_refused(const std::string& text, const std::string& part) {
        const std::string error = message_thrown_by([&] { obstacle(text); });
        EXPECT_NE(error.find("scene.toml:"), std::string::npos) << error;
        EXPECT_NE(error.find(part), std::string::npos) << error;
    }

    TemporaryDirectory directory;
    std::vector<std::string> warnings;
};

TEST_F(SceneCache, MovesTheVerticesThatFacesUse) {
    const Obstacle hand = obstacle("mesh = \"hand.obj\"\ncache = \"hand.pc2\"\nfriction = 0.2\nyoung = 1e6");
    ASSERT_TRUE(hand.deformation);
    EXPECT_EQ(hand.surface->triangles.size(), 3u);
    EXPECT_EQ(hand.surface->edges.size(), 7u) << "the diagonal may bend";
    EXPECT_EQ(hand.deformation->times, (std::vector<double>{0, 1 / 24.0, 2 / 24.0}));
    ASSERT_EQ(hand.points_at(0).cols(), 5) << "one is used by no face";
    EXPECT_LT((hand.points_at(1 / 24.0).col(4) - Vector3d(2, 0, 1)).norm(), 1e-12);
    EXPECT_TRUE(hand.moves());
    EXPECT_EQ(hand.friction, 0.2);
    EXPECT_EQ(hand.young, 1e6);
    EXPECT_TRUE(hand.deformation->smooth);
}

TEST_F(SceneCache, IsPlacedScaledAndMovedLikeTheMesh) {
    const Obstacle hand = obstacle(R"(mesh = { file = "hand.obj", scale = 0.1 }
place = { translate = [0, 0, 5], rotate = { axis = [0, 0, 1], degrees = 90 } }
cache = { file = "hand.mdd", start = 0.2, interpolation = "linear" }
keys = [{ time = 0 }, { time = 1, translate = [1, 0, 0] }]
motion = "linear"
)");
    EXPECT_FALSE(hand.deformation->smooth);
    EXPECT_NEAR(hand.deformation->times[2], 0.6, 1e-7);
    EXPECT_LT((hand.points_at(0).col(1) - Vector3d(0, 0.1, 5)).norm(), 1e-7);
    EXPECT_LT((hand.points_at(0.25).col(1) - Vector3d(0.25, 0.1, 5.05)).norm(), 1e-7);
    EXPECT_LT((hand.points_at(3).col(1) - Vector3d(1, 0.1, 5.2)).norm(), 1e-7);
    const Obstacle fast = obstacle("mesh = \"hand.obj\"\ncache = { file = \"hand.mdd\", fps = 1000 }");
    EXPECT_EQ(fast.deformation->times[2], 2 / 1000.0);
}

TEST_F(SceneCache, RefusesWhatDoesNotFit) {
    expect_refused("sphere = { radius = 1 }\ncache = \"hand.pc2\"", "thing.cache: is for a mesh");
    expect_refused("mesh = \"hand.obj\"\ncache = \"hand.pc2\"\ndensity = 1", "conflicts with density");
    for (const char* key : {"voxel = 0.1", "join = true", "repair = false"})
        expect_refused(std::string("mesh = { file = \"hand.obj\", ") + key + " }\ncache = \"hand.pc2\"",
                       "takes the mesh as it is in the file");
    expect_refused("mesh = \"hand.obj\"\ncache = { file = \"hand.pc2\", fps = 0 }", "fps");
    expect_refused("mesh = \"hand.obj\"\ncache = { file = \"hand.pc2\", interpolation = \"none\" }",
                   "interpolation");
    expect_refused("mesh = \"hand.obj\"\ncache = \"none.pc2\"", "none.pc2: no such point cache");
    directory.write("small.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    expect_refused("mesh = \"small.obj\"\ncache = \"hand.pc2\"", "holds 6 points, but");
    expect_refused("mesh = { file = \"hand.obj\", scale = 1e10 }\ncache = \"hand.pc2\"", "m from the origin");
    std::vector<Positions> flat = raised_samples(2);
    flat[0].col(2) = flat[0].col(1);
    directory.write("flat.pc2", pc2_of(flat));
    expect_refused("mesh = \"hand.obj\"\ncache = \"flat.pc2\"", "points 1 and 2, which an edge joins");
    directory.write("hand.stl", "solid\nendsolid\n");
    expect_refused("mesh = \"hand.stl\"\ncache = \"hand.pc2\"", "no numbered vertices");
}

// A common mistake is a cache that ends early, or has hardly begun at the end of the run, because its frames
// have another rate.
TEST_F(SceneCache, WarnsOfWhatTheRunDoesNotSee) {
    const auto warned = [&](const std::string& cache) {
        const Scene read = scene("mesh = \"hand.obj\"\ncache = { file = \"hand.pc2\", " + cache + " }\n");
        warnings.clear();
        const BuiltScene built = build_scene(read, warnings);
        warn_of_implausible(read, built.inputs, built.options, warnings);
        std::string all;
        for (const std::string& warning : warnings) all += warning + "\n";
        return all;
    };
    EXPECT_NE(warned("fps = 1000").find("ends at 0.002 s, the run at 0.05 s"), std::string::npos);
    EXPECT_NE(warned("fps = 1").find("of which the run covers 0.05 s"), std::string::npos);
    const std::string usual = warned("fps = 24");
    EXPECT_EQ(usual.find("hand.pc2"), std::string::npos) << usual;
}

}  // namespace
}  // namespace sherd::test
