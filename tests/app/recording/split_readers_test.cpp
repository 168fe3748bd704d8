// SPDX-License-Identifier: GPL-3.0-or-later
// Exports, pictures and the page of a recorded run that splits faces: a reader that ignored the new faces
// would show another run.
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/recording/recording_table.h"
#include "app/render/render_solid.h"
#include "app/render/render_stripes.h"
#include "app/view/view_data.h"
#include "meshops/topology/components.h"
#include "tests/support/program/base64.h"
#include "tests/support/program/program.h"
#include "tests/support/recording/glb_content.h"
#include "tests/support/recording/split_run.h"

namespace sherd::test {
namespace {

/// Test with a recording of split_run().
class SplitReaders : public Export {
  protected:
    SplitReaders() {
        run = split_run();
        std::filesystem::remove(folder.path / "run.h5");
        std::filesystem::remove(folder.path / "run.xdmf");
        record(run, folder.path / "run.h5");
    }

    /// Position in a frame of a vertex of the last frame: each vertex moves with its piece, which moves
    /// rigidly.
    Vector3d expected(Index vertex, std::size_t frame) const {
        static const std::set<Index> left{0, 1, 3, split::m};
        const Index piece = left.contains(vertex) ? 0 : 1;
        return split::motion(frame, piece) * split::between_parents(run.header.rest_position, vertex);
    }

    ExportOptions all_frames(const std::string& format, const std::string& output) const {
        ExportOptions wanted = options(format, output);
        wanted.slow = {1, 10};  // so that the samples are the frames
        return wanted;
    }
};

TEST_F(SplitReaders, CachesHaveTheLastMeshInAllFrames) {
    EXPECT_TRUE(export_recording(all_frames("pc2", "out.pc2")).warnings.empty());
    export_recording(all_frames("mdd", "cache.mdd"));
    Bytes pc2(bytes("out.pc2"), 16), mdd(bytes("cache.mdd"));
    EXPECT_EQ(pc2.next<std::int32_t>(), 11);
    pc2.text(8);
    ASSERT_EQ(pc2.next<std::int32_t>(), 5);
    EXPECT_EQ(mdd.next_big_endian<std::int32_t>(), 5);
    EXPECT_EQ(mdd.next_big_endian<std::int32_t>(), 11);
    mdd.text(5 * sizeof(float));
    for (std::size_t k = 0; k < 5; ++k)
        for (Index v = 0; v < 11; ++v)
            for (const double x : expected(v, k)) {
                EXPECT_NEAR(pc2.next<float>(), x, 1e-6) << "vertex " << v << " in frame " << k;
                EXPECT_NEAR(mdd.next_big_endian<float>(), x, 1e-6) << "vertex " << v << " in frame " << k;
            }
    EXPECT_TRUE(pc2.at_end() && mdd.at_end());
    EXPECT_EQ(read("out.obj").number_of_faces(), 9u);
}

// Pieces must have their positions in every frame, even if a face is split into ever smaller parts.
TEST_F(SplitReaders, GlbMovesPiecesRigidlyAndMorphsThem) {
    for (const std::string animate : {"rigid", "morph"}) {
        ExportOptions wanted = options("glb", animate + ".glb");
        wanted.animate = animate;
        EXPECT_TRUE(export_recording(wanted).warnings.empty()) << "rigid motion fits";
        const Glb glb(bytes(animate + ".glb"));
        const nlohmann::json& nodes = glb.json["nodes"][0]["children"];
        ASSERT_EQ(nodes.size(), 2u);
        const std::vector<Index> vertices[] = {{0, 1, 3, 5}, {2, 4, 6, 7, 8, 9, 10}};
        for (std::size_t piece = 0; piece < 2; ++piece) {
            const nlohmann::json& primitive =
                glb.primitive(glb.json["nodes"][nodes[piece].get<std::size_t>()]);
            const Cloud points = glb.cloud(primitive["attributes"]["POSITION"]);
            ASSERT_EQ(points.size(), vertices[piece].size());
            EXPECT_EQ(glb.values<std::uint32_t>(primitive["indices"], 1).size(), piece == 0 ? 6u : 21u);
            for (std::size_t k = 0; k < 5; ++k) {
                Cloud found = points;
                if (animate == "rigid") {
                    const auto t = glb.values<float>(glb.track(nodes[piece], "translation"), 3);
                    const auto q = glb.values<float>(glb.track(nodes[piece], "rotation"), 4);
                    for (Eigen::Vector3f& point : found)
                        point = Eigen::Quaternionf(&q[4 * k]) * point + Eigen::Vector3f(&t[3 * k]);
                } else if (k > 0) {
                    const Cloud change = glb.cloud(primitive["targets"][k - 1]["POSITION"]);
                    for (std::size_t i = 0; i < found.size(); ++i) found[i] += change[i];
                }
                for (std::size_t i = 0; i < found.size(); ++i)
                    EXPECT_LT((found[i].cast<double>() - expected(vertices[piece][i], k)).norm(), 1e-6)
                        << animate;
            }
        }
    }
}

TEST_F(SplitReaders, MeshesOfEachFrameAreItsOwn) {
    ExportOptions wanted = options("obj", "frames");
    wanted.frames = "all";
    wanted.fragments = true;
    ASSERT_EQ(export_recording(wanted).files.size(), 5u);
    wanted = options("pvd", "frames");
    export_recording(wanted);
    wanted = options("ply", "pieces");
    wanted.fragments = true;
    EXPECT_EQ(export_recording(wanted).files.size(), 2u);
    for (std::size_t k = 0; k < 5; ++k) {
        const Mesh mesh = read("frames/run_00000" + std::to_string(k) + ".obj");
        EXPECT_EQ(mesh.number_of_faces(), run.frames[k].faces.size());
        EXPECT_EQ(connected_components(mesh).count, k < 2 ? 1 : 2);
        const std::string vtp = bytes("frames/run_00000" + std::to_string(k) + ".vtp");
        EXPECT_NE(vtp.find("NumberOfPolys=\"" + std::to_string(run.frames[k].faces.size()) + "\""),
                  std::string::npos);
    }
}

// A part must have the thickness of its parent face.
TEST_F(SplitReaders, BodiesHaveTheThicknessOfTheFacesThatWereSplit) {
    for (const std::string frame : {"1", "4"}) {
        ExportOptions wanted = options("obj", "solid.obj");
        wanted.solid = wanted.force = true;
        wanted.frames = frame;
        EXPECT_TRUE(export_recording(wanted).warnings.empty());
        const Mesh mesh = read("solid.obj");
        EXPECT_TRUE(CGAL::is_closed(mesh));
        EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(mesh), 2e-3, 1e-5) << "1 m^2 of 1 mm, half of 2 mm";
    }
    ExportOptions cache = all_frames("pc2", "body.pc2");
    cache.solid = true;
    export_recording(cache);
    EXPECT_EQ(bytes("body.pc2").size(), 32u + 5 * 12 * 22);
}

TEST_F(SplitReaders, TheRimIsSmoothAndTheCrackBroken) {
    const std::pair<std::size_t, std::size_t> rim_and_broken[] = {{5, 0}, {5, 0}, {5, 4}, {5, 4}, {5, 4}};
    for (std::size_t k = 0; k < 5; ++k) {
        const Snapshot& frame = run.frames[k];
        SheetPaint paint;
        paint.colour.assign(frame.position.cols(), Eigen::Vector3f::Ones());
        const RenderMesh mesh = sheet_solid(frame, frame.rest.thickness, paint, Vector3d::Zero());
        std::size_t rim = 0, broken = 0;
        for (std::size_t v = 2 * frame.original.size(); v < mesh.vertices.size(); v += 4)
            ++(mesh.vertices[v].broken > 0 ? broken : rim);
        EXPECT_EQ(std::pair(rim, broken), rim_and_broken[k]) << "frame " << k;
    }
    // If only one side of an open crack is split into parts, the crack must not count as rim, either.
    RestMesh rest = run.frames[1].rest;
    rest.faces[1] = {0, 2, 3};
    rest.faces.pop_back();
    rest.face_parent.pop_back();
    for (const auto& sides : {rim_edges(rest)[0], rim_edges(rest)[3]}) EXPECT_FALSE(sides[2]);
}

// Stripes that jump at the edge between two parts of a face would look like a crack.
TEST_F(SplitReaders, StripesGoOnWhereAFaceWasSplit) {
    Eigen::Matrix3Xd stripes(3, 3);  // 2 x + 3 y at the corners of the unfractured faces
    const auto value = [](const Vector3d& p) { return 2 * p.x() + 3 * p.y(); };
    for (int f = 0; f < 3; ++f)
        for (int k = 0; k < 3; ++k)
            stripes(k, f) = value(run.header.rest_position.col(run.header.rest_faces[f][k]));
    for (const Snapshot& frame : run.frames) {
        const Eigen::Matrix3Xd parts = stripes_of_parts(frame.rest, stripes);
        for (std::size_t f = 0; f < frame.faces.size(); ++f)
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(parts(k, f), value(frame.rest.position.col(frame.rest.faces[f][k])), 1e-14);
    }
}

TEST_F(SplitReaders, PicturesAndFilmsAreDrawn) {
    const std::vector<std::string> small{"--size", "96x54", "--samples", "2", "--force"};
    for (const std::string colour : {"fragment", "strain", "speed"}) {
        std::vector<std::string> command{"render",   "run.h5", "-o",      "pictures",
                                         "--frames", "all",    "--color", colour};
        command.insert(command.end(), small.begin(), small.end());
        const ProgramResult result = run_sherd(command, folder.path);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    EXPECT_NE(bytes("pictures/run_000001.png"), bytes("pictures/run_000002.png"));
}

TEST_F(SplitReaders, ThePageHasWhereVerticesAndFacesWereInserted) {
    const Recording recording(folder.path / "run.h5");
    StageOptions options;
    options.colour = RenderColour::strain;
    std::vector<std::string> warnings;
    const RenderStage stage(recording, options, warnings);
    const nlohmann::json page = view_data(recording, stage, {0, 1, 3});
    const auto numbers = [&](std::size_t frame, const char* name) {
        return decoded<std::uint32_t>(page["frames"][frame][name]);
    };
    EXPECT_TRUE(numbers(0, "born").empty() && numbers(0, "parts").empty());
    EXPECT_EQ(numbers(1, "born"), (std::vector<std::uint32_t>{split::m, 0, 2, 3}));
    EXPECT_EQ(decoded<float>(page["frames"][1]["shares"]), (std::vector<float>{0.75F, 0.25F, 0}));
    EXPECT_EQ(numbers(1, "parts"), (std::vector<std::uint32_t>{3, 0, 4, 1}));
    EXPECT_EQ(numbers(2, "parts"), (std::vector<std::uint32_t>{5, 2, 6, 2, 7, 3, 8, 4}));
    EXPECT_EQ(decoded<float>(page["thickness"]).size(), 9u);
    // Edges that open in frames 1 to 3 are a crack, all others the original rim
    std::map<std::uint32_t, int> states;
    const auto lines = numbers(2, "lines");
    for (std::size_t i = 2; i < lines.size(); i += 3) ++states[lines[i]];
    EXPECT_EQ(states, (std::map<std::uint32_t, int>{{0, 5}, {2, 4}}));
}

// A face must stay in the thinned mesh while parts of it appear and vanish.
TEST_F(SplitReaders, AThinnedMeshHasTheSameFacesInAllFrames) {
    const MeshThinning thinning(run.header, run.frames[4].face_sheet, 0.4);
    for (const Snapshot& frame : run.frames) {
        const Snapshot coarse = thinning.thinned(frame);
        ASSERT_EQ(coarse.faces.size(), 3u);
        for (std::size_t f = 0; f < 3; ++f) {
            EXPECT_EQ(coarse.rest.thickness[f], run.header.rest_thickness[f]);
            for (const Index v : coarse.faces[f]) EXPECT_TRUE(coarse.position.col(v).allFinite());
        }
        EXPECT_EQ(coarse.face_fragment[2], frame.face_fragment[2]);
    }
}

}  // namespace
}  // namespace sherd::test
