// SPDX-License-Identifier: GPL-3.0-or-later
// Exported files that contain all frames (pc2, mdd, glb), read back byte by byte.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/program/program.h"
#include "tests/support/recording/export_fixture.h"
#include "tests/support/recording/glb_content.h"

namespace sherd::test {
namespace {

using Json = nlohmann::json;

/// Vertex of a frame from which `vertex` of the last frame was split, directly or by several recorded splits.
Index ancestor(const SyntheticRun& run, Index vertex, std::size_t frame) {
    std::map<Index, Index> parent;
    for (const CrackEvents& events : run.events)
        for (const VertexSplit& split : events.splits) parent[split.created] = split.vertex;
    while (vertex >= static_cast<Index>(run.frames[frame].original.size())) vertex = parent.at(vertex);
    return vertex;
}

/// Positions that the last frame's vertices, or their ancestors, have in each frame.
std::vector<Cloud> expected_clouds(const SyntheticRun& run) {
    std::vector<Cloud> clouds;
    for (std::size_t k = 0; k < run.frames.size(); ++k) {
        Cloud& cloud = clouds.emplace_back();
        for (Index v = 0; v < static_cast<Index>(run.frames.back().original.size()); ++v)
            cloud.push_back(run.frames[k].position.col(ancestor(run, v, k)).cast<float>());
    }
    return clouds;
}

/// Options with which the samples of a cache are the frames of the synthetic run, 0.1 s apart.
ExportOptions of_frames(ExportOptions options) {
    options.slow = {1, 10};
    return options;
}

TEST_F(Export, Pc2HasTheLastTopologyFromTheFirstFrameOn) {
    const auto files = export_recording(of_frames(options("pc2", "out.pc2"))).files;
    EXPECT_EQ(files, (std::vector<std::filesystem::path>{folder.path / "out.obj", folder.path / "out.pc2"}));
    const std::vector<Cloud> clouds = expected_clouds(run);
    Bytes pc2(bytes("out.pc2"));
    EXPECT_EQ(pc2.text(12), std::string("POINTCACHE2\0", 12));
    EXPECT_EQ(pc2.next<std::int32_t>(), 1);
    EXPECT_EQ(pc2.next<std::int32_t>(), static_cast<int>(clouds[0].size()));
    EXPECT_EQ(pc2.next<float>(), 0);
    EXPECT_EQ(pc2.next<float>(), 1);
    ASSERT_EQ(pc2.next<std::int32_t>(), 3);
    for (const Cloud& cloud : clouds)
        for (const Eigen::Vector3f& point : cloud)
            for (const float x : point) ASSERT_EQ(pc2.next<float>(), x);
    EXPECT_TRUE(pc2.at_end());
    const Mesh mesh = read("out.obj");
    ASSERT_EQ(mesh.number_of_vertices(), clouds[0].size());
    EXPECT_EQ(mesh.number_of_faces(), 96u);
    for (const Vertex v : mesh.vertices())
        EXPECT_EQ(static_cast<float>(mesh.point(v).x()), clouds[0][v.idx()].x()) << "the order of the cache";
}

TEST_F(Export, MddIsBigEndianAndKnowsTheTimes) {
    export_recording(of_frames(options("mdd", "out.mdd")));
    const std::vector<Cloud> clouds = expected_clouds(run);
    Bytes mdd(bytes("out.mdd"));
    EXPECT_EQ(mdd.next_big_endian<std::int32_t>(), 3);
    EXPECT_EQ(mdd.next_big_endian<std::int32_t>(), static_cast<int>(clouds[0].size()));
    for (const Snapshot& frame : run.frames)
        EXPECT_EQ(mdd.next_big_endian<float>(), static_cast<float>(frame.time));
    for (const Cloud& cloud : clouds)
        for (const Eigen::Vector3f& point : cloud)
            for (const float x : point) ASSERT_EQ(mdd.next_big_endian<float>(), x);
    EXPECT_TRUE(mdd.at_end());
}

// Other programs play a cache at its own rate, so that slow motion needs samples between frames, where
// positions must be linear in time.
TEST_F(Export, CachesAreSlowMotion) {
    ExportOptions wanted = options("pc2", "out.pc2");
    EXPECT_EQ(export_recording(wanted).pace,
              "20 times slower than reality: 0.2 s last 4 s, 97 samples at 24 per second");
    const std::vector<Cloud> clouds = expected_clouds(run);
    Bytes pc2(bytes("out.pc2"), 28);
    ASSERT_EQ(pc2.next<std::int32_t>(), 97);
    for (std::size_t i = 0; i < 97; ++i) {  // 48 samples from frame to frame
        const std::size_t before = std::min<std::size_t>(i / 48, 1);
        const float share = static_cast<float>(i - 48 * before) / 48;
        for (std::size_t v = 0; v < clouds[0].size(); ++v)
            for (int k = 0; k < 3; ++k) {
                const float from = clouds[before][v][k], to = clouds[before + 1][v][k];
                ASSERT_NEAR(pc2.next<float>(), from + share * (to - from), 1e-7F) << i << " " << v;
            }
    }
    EXPECT_TRUE(pc2.at_end());
    wanted = options("mdd", "out.mdd");
    wanted.slow = {50, 30};
    wanted.frames = "1:";
    wanted.force = true;
    export_recording(wanted);
    Bytes mdd(bytes("out.mdd"));
    ASSERT_EQ(mdd.next_big_endian<std::int32_t>(), 151) << "5 s";
    mdd.next_big_endian<std::int32_t>();
    for (int i = 0; i < 151; ++i) ASSERT_NEAR(mdd.next_big_endian<float>(), i / 30.0, 1e-6);
}

TEST_F(Export, SolidCachesFitTheirSolidMesh) {
    ExportOptions wanted = of_frames(options("pc2", "out.pc2"));
    wanted.solid = true;
    export_recording(wanted);
    const Mesh mesh = read("out.obj");
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(mesh.number_of_vertices(), 2 * run.frames[2].original.size());
    EXPECT_EQ(bytes("out.pc2").size(), 32 + 3 * 12 * mesh.number_of_vertices());
}

// Existing files must stop the export before anything is written: here the mesh that belongs to the cache
// exists.
TEST_F(Export, CacheKeepsAMeshThatIsThere) {
    folder.write("out.obj", "the only copy");
    const auto before = folder.contents();
    EXPECT_NE(error_of(options("pc2", "out.pc2")).find("out.obj"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
}

/// Whether each edge occurs once in each direction, with coincident points counted as one.
bool is_closed(const std::vector<std::uint32_t>& indices, const Cloud& points) {
    std::map<std::array<float, 3>, std::uint32_t> joint;
    const auto number = [&](std::uint32_t i) {
        const Eigen::Vector3f& at = points[i];
        return joint.try_emplace({at.x(), at.y(), at.z()}, i).first->second;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> walked;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (int k = 0; k < 3; ++k) ++walked[{number(indices[i + k]), number(indices[i + (k + 1) % 3])}];
    return std::ranges::all_of(walked, [&](const auto& edge) {
        return edge.second == 1 && walked.contains({edge.first.second, edge.first.first});
    });
}

/// Positions in a frame of the corners of a fragment of the last frame, face by face.
Cloud corners(const SyntheticRun& run, Index fragment, std::size_t frame) {
    Cloud cloud;
    for (std::size_t f = 0; f < run.frames.back().faces.size(); ++f)
        if (run.frames.back().face_fragment[f] == fragment)
            for (const Index v : run.frames[frame].faces[f])
                cloud.push_back(run.frames[frame].position.col(v).cast<float>());
    return cloud;
}

void expect_near(const Cloud& found, const Cloud& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT((found[i] - expected[i]).norm(), 1e-6F);
}

/// Rotates and moves everything, farther from frame to frame.
void set_in_motion(SyntheticRun& run) {
    for (std::size_t k = 0; k < run.frames.size(); ++k) {
        const double angle = 1.9 * static_cast<double>(k);
        Eigen::Isometry3d motion(Eigen::AngleAxisd(angle, Vector3d(1, 2, 2) / 3));
        motion.pretranslate(Vector3d(0.1 * angle, 0, 0.3));
        for (Index v = 0; v < static_cast<Index>(run.frames[k].original.size()); ++v)
            run.frames[k].position.col(v) = motion * Vector3d(run.frames[k].position.col(v));
    }
}

TEST_F(Export, GlbMovesFragmentsRigidly) {
    run = synthetic_run();
    set_in_motion(run);
    record(run, folder.path / "moving.h5");
    ExportOptions wanted = options("glb", "out.glb");
    wanted.recording = folder.path / "moving.h5";
    export_recording(wanted);
    const Glb glb(bytes("out.glb"));
    const Json& root = glb.json["nodes"][0];
    ASSERT_EQ(root["children"].size(), 3u);
    EXPECT_NEAR(root["rotation"][0].get<double>(), -std::sqrt(0.5), 1e-7) << "z up becomes y up";
    for (Index fragment = 0; fragment < 3; ++fragment) {
        const std::size_t node = root["children"][fragment];
        EXPECT_EQ(glb.json["nodes"][node]["name"], "fragment_00" + std::to_string(fragment));
        const Json& primitive = glb.primitive(glb.json["nodes"][node]);
        const Cloud points = glb.cloud(primitive["attributes"]["POSITION"]);
        const auto indices = glb.values<std::uint32_t>(primitive["indices"], 1);
        const auto t = glb.values<float>(glb.track(node, "translation"), 3);
        const auto q = glb.values<float>(glb.track(node, "rotation"), 4);
        Eigen::Quaternionf last(&q[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Quaternionf turn(&q[4 * k]);  // order: x, y, z, w
            EXPECT_NEAR(turn.norm(), 1, 1e-6);
            EXPECT_GE(turn.dot(last), 0) << "the long way round";
            last = turn;
            Cloud found;
            for (const auto i : indices) found.push_back(turn * points[i] + Eigen::Vector3f(&t[3 * k]));
            expect_near(found, corners(run, fragment, k));
        }
    }
}

TEST_F(Export, GlbMorphsThroughTheRecordedShapes) {
    ExportOptions wanted = options("glb", "out.glb");
    wanted.animate = "morph";
    export_recording(wanted);
    const Glb glb(bytes("out.glb"));
    for (Index fragment = 0; fragment < 3; ++fragment) {
        const std::size_t node = glb.json["nodes"][0]["children"][fragment];
        const Json& primitive = glb.primitive(glb.json["nodes"][node]);
        const Cloud first = glb.cloud(primitive["attributes"]["POSITION"]);
        const auto indices = glb.values<std::uint32_t>(primitive["indices"], 1);
        const auto weights = glb.values<float>(glb.track(node, "weights"), 1);
        EXPECT_EQ(weights, (std::vector<float>{0, 0, 1, 0, 0, 1}));
        ASSERT_EQ(primitive["targets"].size(), 2u);
        for (std::size_t k = 0; k < 3; ++k) {
            const Cloud change = k == 0 ? Cloud(first.size(), Eigen::Vector3f::Zero())
                                        : glb.cloud(primitive["targets"][k - 1]["POSITION"]);
            Cloud found;
            for (const auto i : indices) found.push_back(first[i] + change[i]);
            expect_near(found, corners(run, fragment, k));
        }
    }
}

// Requirements of the format on which readers depend: bounds, unit normals, indices in range, increasing
// times.
TEST_F(Export, GlbIsWellFormed) {
    for (const std::string animate : {"rigid", "morph"})
        for (const bool solid : {false, true}) {
            ExportOptions wanted = options("glb", animate + ".glb");
            wanted.animate = animate;
            wanted.solid = solid;
            wanted.force = true;
            wanted.slow.factor = 1;
            export_recording(wanted);
            const Glb glb(bytes(animate + ".glb"));
            EXPECT_EQ(glb.json["asset"]["version"], "2.0");
            EXPECT_EQ(glb.json["materials"][0].value("doubleSided", false), !solid);
            const std::size_t input = glb.json["animations"][0]["samplers"][0]["input"];
            EXPECT_EQ(glb.values<float>(input, 1), (std::vector<float>{0, 0.1F, 0.2F}));
            EXPECT_EQ(glb.json["accessors"][input]["max"][0].get<float>(), 0.2F);
            for (const Json& mesh : glb.json["meshes"]) {
                const Json& attributes = mesh["primitives"][0]["attributes"];
                const Cloud points = glb.cloud(attributes["POSITION"]),
                            normals = glb.cloud(attributes["NORMAL"]);
                ASSERT_EQ(points.size(), normals.size());
                for (const auto& normal : normals) EXPECT_NEAR(normal.norm(), 1, 1e-5);
                const auto indices = glb.values<std::uint32_t>(mesh["primitives"][0]["indices"], 1);
                EXPECT_EQ(is_closed(indices, points), solid);
                for (const auto i : indices) ASSERT_LT(i, points.size());
                const Json& accessor = glb.json["accessors"][attributes["POSITION"].get<std::size_t>()];
                for (int axis = 0; axis < 3; ++axis)
                    for (const auto& point : points) {
                        EXPECT_LE(accessor["min"][axis].get<float>(), point[axis]);
                        EXPECT_GE(accessor["max"][axis].get<float>(), point[axis]);
                    }
            }
        }
}

TEST_F(Export, GlbIsSlowMotion) {
    const auto times = [&](const ExportOptions& wanted) {
        export_recording(wanted);
        const Glb glb(bytes("out.glb"));
        return glb.values<float>(glb.json["animations"][0]["samplers"][0]["input"], 1);
    };
    ExportOptions wanted = options("glb", "out.glb");
    EXPECT_EQ(times(wanted), (std::vector<float>{0, 2, 4})) << "20 times slower";
    wanted.force = true;
    wanted.slow.factor = 150;
    wanted.frames = "1:";
    EXPECT_EQ(times(wanted), (std::vector<float>{0, 15}));
}

TEST_F(Export, RefusesASlowMotionThatMakesNoSense) {
    const auto before = folder.contents();
    const auto refused = [&](const std::string& format, const SlowMotion& slow, const std::string& word) {
        ExportOptions wanted = options(format, "out." + format);
        wanted.slow = slow;
        EXPECT_NE(error_of(wanted).find(word), std::string::npos) << format;
    };
    refused("glb", {0, {}}, "--slow 0: give how many times slower");
    refused("pc2", {-5, {}}, "--slow -5");
    refused("mdd", {1, 0}, "--rate 0");
    refused("pc2", {1e9, {}}, "more than 100000");
    refused("obj", {2, {}}, "--to glb, pc2 and mdd");
    refused("glb", {{}, 25}, "--to pc2 and mdd");
    EXPECT_EQ(folder.contents(), before);
    const ProgramResult result = run_sherd({"export", "run.h5", "--to", "glb", "--slow", "0"}, folder.path);
    EXPECT_EQ(result.exit_code, 2) << result.err;
}

TEST_F(Export, GlbOfOneFrameStandsStill) {
    ExportOptions wanted = options("glb", "out.glb");
    wanted.frames = "0";
    EXPECT_EQ(export_recording(wanted).pace, "");
    const Glb glb(bytes("out.glb"));
    EXPECT_FALSE(glb.json.contains("animations"));
    EXPECT_EQ(glb.json["meshes"].size(), 1u);
}

TEST_F(Export, EveryFormatRefusesARunWithoutFrames) {
    run.frames.clear();
    record(run, folder.path / "empty.h5");
    const auto before = folder.contents();
    for (const std::string format : {"obj", "ply", "stl", "vdb", "pvd", "pc2", "mdd", "glb"}) {
        ExportOptions wanted = options(format, "out." + format);
        wanted.recording = folder.path / "empty.h5";
        EXPECT_NE(error_of(wanted).find("no frame yet"), std::string::npos) << format;
    }
    EXPECT_EQ(folder.contents(), before);
}

TEST_F(Export, RefusesAnAnimationThatIsNone) {
    const auto before = folder.contents();
    ExportOptions wanted = options("glb", "out.glb");
    wanted.animate = "jump";
    EXPECT_NE(error_of(wanted).find("rigid or morph"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
}

}  // namespace
}  // namespace sherd::test
