// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "app/recording/hdf5.h"
#include "meshops/topology/components.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/recording/export_fixture.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<std::size_t>;

/// Number of faces of each object (line `o`) of an OBJ file.
std::map<std::string, int> object_faces(const fs::path& file) {
    std::ifstream stream(file);
    std::map<std::string, int> faces;
    std::string object;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("o ")) object = line.substr(2);
        if (line.starts_with("f ")) ++faces[object];
    }
    return faces;
}

TEST_F(Export, WritesTheLastFrameWithEveryFaceInItsPlace) {
    for (const std::string format : {"obj", "ply"}) {
        export_recording(options(format, "out." + format));
        const Mesh mesh = read("out." + format);
        const Snapshot& frame = run.frames[2];
        ASSERT_EQ(mesh.number_of_faces(), frame.faces.size());
        ASSERT_EQ(mesh.number_of_vertices(), frame.original.size());
        EXPECT_EQ(connected_components(mesh).count, 3);
        for (const Vertex v : mesh.vertices()) {
            const Vector3d expected = frame.position.col(v.idx());
            EXPECT_EQ(Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()), expected);
        }
    }
}

TEST_F(Export, ObjFragmentsAreObjects) {
    ExportOptions wanted = options("obj", "out.obj");
    wanted.fragments = true;
    export_recording(wanted);
    EXPECT_EQ(object_faces(folder.path / "out.obj"),
              (std::map<std::string, int>{{"fragment_000", 24}, {"fragment_001", 24}, {"fragment_002", 48}}));
    EXPECT_EQ(read("out.obj").number_of_faces(), 96u);
}

TEST_F(Export, PlyFragmentsAreFiles) {
    ExportOptions wanted = options("ply", "out.ply");
    wanted.fragments = true;
    EXPECT_EQ(export_recording(wanted).files.size(), 3u);
    std::size_t vertices = 0;
    for (int i = 0; i < 3; ++i) {
        const Mesh mesh = read("out_fragment_00" + std::to_string(i) + ".ply");
        EXPECT_EQ(mesh.number_of_faces(), i < 2 ? 24u : 48u);
        vertices += mesh.number_of_vertices();
    }
    EXPECT_EQ(vertices, run.frames[2].original.size());
}

TEST_F(Export, PlyHasAFragmentPropertyAnyway) {
    export_recording(options("ply", "out.ply"));
    EXPECT_NE(folder.contents().at(folder.path / "out.ply").find("property int fragment"), std::string::npos);
}

TEST_F(Export, NumbersSequencesByFrame) {
    ExportOptions wanted = options("obj", "frames");
    wanted.frames = "0,2";
    const std::vector<fs::path> files = export_recording(wanted).files;
    const fs::path expected = folder.path / "frames";
    EXPECT_EQ(files, (std::vector<fs::path>{expected / "run_000000.obj", expected / "run_000002.obj"}));
    EXPECT_EQ(connected_components(read("frames/run_000000.obj")).count, 1);
    EXPECT_EQ(connected_components(read("frames/run_000002.obj")).count, 3);
    wanted = options("obj", "out.obj");
    wanted.frames = "all";
    EXPECT_EQ(export_recording(wanted).files.back(), folder.path / "out_000002.obj");
}

TEST_F(Export, WritesBesideTheRecordingByDefault) {
    ExportOptions wanted = options("ply", "");
    wanted.output.clear();
    EXPECT_EQ(export_recording(wanted).files, std::vector<fs::path>{folder.path / "run.ply"});
}

// A single existing file must stop a long sequence before its first file, not in the middle.
TEST_F(Export, KeepsWhatIsThereUnlessForced) {
    folder.write("out_000002.obj", "the only copy");
    const auto before = folder.contents();
    ExportOptions wanted = options("obj", "out.obj");
    wanted.frames = "all";
    const std::string error = error_of(wanted);
    EXPECT_NE(error.find("out_000002.obj"), std::string::npos) << error;
    EXPECT_NE(error.find("--force"), std::string::npos) << error;
    EXPECT_EQ(folder.contents(), before);
    wanted.force = true;
    EXPECT_EQ(export_recording(wanted).files.size(), 3u);
    EXPECT_EQ(read("out_000002.obj").number_of_faces(), 96u);
}

TEST_F(Export, TellsWhatIsCompleteWhenASequenceFails) {
    ExportOptions wanted = options("obj", "out.obj");
    wanted.frames = "all";
    wanted.recording = folder.path / "damaged.h5";
    run.frames[2].face_fragment.assign(96, 0);
    record(run, wanted.recording);
    hdf5::remove(open_to_edit(wanted.recording), "frames/000002/vertex/mass");
    const std::string error = error_of(wanted);
    EXPECT_NE(error.find("2 of 3 files are complete, up to "), std::string::npos) << error;
    EXPECT_TRUE(fs::exists(folder.path / "out_000001.obj"));
    EXPECT_FALSE(fs::exists(folder.path / "out_000002.obj"));
}

TEST_F(Export, RefusesBadOptionsAndWritesNothing) {
    const auto before = folder.contents();
    EXPECT_NE(error_of(options("fbx", "out.fbx")).find("obj, ply"), std::string::npos);
    EXPECT_NE(error_of(options("obj", "out.ply")).find("does not fit"), std::string::npos);
    EXPECT_NE(error_of(options("obj", "missing/out.obj")).find("missing"), std::string::npos);
    EXPECT_NE(error_of(options("obj", "run.h5/deep")).find("run.h5"), std::string::npos);
    ExportOptions wanted = options("obj", "out.obj");
    wanted.frames = "3";
    EXPECT_NE(error_of(wanted).find("no frame 3"), std::string::npos);
    wanted.recording = folder.path / "none.h5";
    EXPECT_NE(error_of(wanted).find("none.h5"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
}

TEST(SelectedFrames, FollowPythonsRanges) {
    EXPECT_EQ(selected_frames("last", 10), (Numbers{9}));
    EXPECT_EQ(selected_frames("all", 3), (Numbers{0, 1, 2}));
    EXPECT_EQ(selected_frames("-1", 10), (Numbers{9}));
    EXPECT_EQ(selected_frames("2:8:3", 10), (Numbers{2, 5}));
    EXPECT_EQ(selected_frames("::4", 10), (Numbers{0, 4, 8}));
    EXPECT_EQ(selected_frames("-3:", 10), (Numbers{7, 8, 9}));
    EXPECT_EQ(selected_frames("8:99", 10), (Numbers{8, 9}));
    EXPECT_EQ(selected_frames("0:9223372036854775807:9223372036854775807", 10), (Numbers{0}));
    EXPECT_EQ(selected_frames("5,1,5,0:2,last", 10), (Numbers{0, 1, 5, 9}));
}

TEST(SelectedFrames, RefuseWhatSelectsNothingOrIsNoFrame) {
    for (const std::string text :
         {"", "10", "-11", "x", "1.5", "1,", "5:2", "0:9:0", "0:9:-1", "1:2:3:4", "99999999999999999999"})
        EXPECT_THROW(selected_frames(text, 10), Error) << text;
    EXPECT_THROW(selected_frames("last", 0), Error);
}

}  // namespace
}  // namespace sherd::test
