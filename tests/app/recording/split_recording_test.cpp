// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of runs that split faces: arrays written and read, and messages about damage.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "app/commands/info/info.h"
#include "app/commands/plot.h"
#include "app/playback/interpolation.h"
#include "app/recording/hdf5.h"
#include "app/recording/hdf5_file.h"
#include "meshops/error.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/program/file_size_limit.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/same_snapshot.h"
#include "tests/support/recording/split_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Whether the mesh at rest of a frame is only a link to that of an earlier frame.
bool is_link(const fs::path& file, std::size_t frame) {
    const hdf5::ReadableFile opened(file);
    H5L_info_t info;
    H5Lget_info(opened, (recording_format::frame_group(frame) + "/rest").c_str(), &info, H5P_DEFAULT);
    return info.type == H5L_TYPE_SOFT;
}

TEST(SplitRecording, KeepsEveryBitAndWritesAMeshAtRestWhenItChanges) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "split.h5";
    const SyntheticRun run = split_run();
    record(run, file);
    const Recording recording(file);
    const bool linked[] = {true, false, false, false, true};
    for (std::size_t k = 0; k < 5; ++k) {
        expect_same(recording.frame(k), run.frames[k]);
        EXPECT_EQ(is_link(file, k), linked[k]) << k;
    }
    const CrackEvents events = recording.events();
    ASSERT_EQ(events.vertex_insertions.size(), 3u);
    EXPECT_EQ(events.vertex_insertions[1].parents, (std::array<Index, 3>{6, 4, 2}));
    EXPECT_EQ(events.vertex_insertions[1].weights, (std::array<double, 3>{0.5, 0.25, 0.25}));
    ASSERT_EQ(events.face_insertions.size(), 6u);
    EXPECT_EQ(events.face_insertions[5].created, 8);
    EXPECT_EQ(events.face_insertions[5].parent, 4);
}

// Runs in which cracks only copy vertices must not store a mesh at rest in each frame.
TEST(SplitRecording, CopiesOfVerticesNeedNoMeshAtRest) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(is_link(folder.path / "run.h5", k)) << k;
}

// A frame that could not be written must not be the place where a later frame's mesh at rest is stored.
TEST(SplitRecording, AFailedAppendIsNoOnesMeshAtRest) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "split.h5";
    const SyntheticRun run = split_run();
    RecordingWriter writer(file, run.header, false);
    writer.append(run.frames[0], {}, {});
    {
        const FileSizeLimit limit(fs::file_size(file) + 5000);
        EXPECT_THROW(writer.append(run.frames[1], {}, {}), Error);
    }
    for (std::size_t k = 1; k < 5; ++k) writer.append(run.frames[k], run.steps[k], run.events[k]);
    for (std::size_t k = 0; k < 5; ++k) expect_same(Recording(file).frame(k), run.frames[k]);
}

TEST(SplitRecording, InfoSharesAreaAndMassOut) {
    const TemporaryDirectory folder;
    const SyntheticRun run = split_run();
    record(run, folder.path / "split.h5");
    const RunInfo info = read_run_info(folder.path / "split.h5");
    EXPECT_EQ(info.faces, 9u);
    EXPECT_EQ(info.vertices, 11u);
    ASSERT_EQ(info.fragments.size(), 2u);
    // The left piece has the quarter of A and of B at vertex 0.
    EXPECT_NEAR(info.fragments[0].area, 0.25, 1e-15);
    EXPECT_NEAR(info.fragments[0].mass, 0.25 * 1e-3 * split::density, 1e-12);
    EXPECT_NEAR(info.fragments[1].area, 1.25, 1e-15);
    EXPECT_NEAR(info.fragments[1].mass, (0.75 * 1e-3 + 0.5 * 2e-3) * split::density, 1e-12);
    EXPECT_EQ(info.fragments[1].parent, 0);
    EXPECT_NEAR(info.sheets.at(0).area, 1.5, 1e-15);
    ASSERT_TRUE(info.membrane_strain);
    EXPECT_NEAR(info.membrane_strain->strain, 0, 1e-12) << "pieces move rigidly";
    EXPECT_NE(run_info_text(info).find("3 vertices split; 3 vertices and 6 faces inserted"),
              std::string::npos);
    EXPECT_NE(run_info_json(info).find("\"faces_born\": 6"), std::string::npos);
}

TEST(SplitRecording, PlotsCracksThroughFacesAsLongAsTheyAreAtRest) {
    const SyntheticRun run = split_run();
    const std::vector<Vector2d> length = crack_length(run.frames[4], run.events[2], 0.4);
    EXPECT_NEAR(length.back().y(), 2 * std::hypot(0.75, 0.25), 1e-14);
    const std::vector<Vector2d> sizes = fragment_sizes(run.frames[4]);
    ASSERT_EQ(sizes.size(), 2u);
    EXPECT_NEAR(sizes[0].x(), 0.25, 1e-15);
}

// Inserted vertices must begin in the face that was split, and move on from there.
TEST(SplitRecording, BetweenFramesInsertedVerticesComeFromTheirFace) {
    const SyntheticRun run = split_run();
    const Snapshot opening = interpolated(run.frames[1], run.frames[2], 0.25);
    ASSERT_EQ(opening.faces.size(), 7u);
    for (const Index v : {split::m, split::right_m, split::in_c}) {
        const Vector3d before = split::between_parents(run.frames[1].position, v);
        const Vector3d expected = 0.75 * before + 0.25 * run.frames[2].position.col(v);
        EXPECT_LT((opening.position.col(v) - expected).norm(), 1e-15) << v;
    }
    EXPECT_EQ(opening.face_fragment, std::vector<Index>(7, 0)) << "pieces count from the later frame on";
    EXPECT_EQ(opening.edge_strain[12], 0.25 * run.frames[2].edge_strain[12]) << "inside a face that was flat";
    // A part of a part: n lies half-way between the copy of m and vertex 2, whose piece had already turned.
    const Snapshot again = interpolated(run.frames[2], run.frames[3], 0.5);
    const Vector3d before = (run.frames[2].position.col(split::right_m) + run.frames[2].position.col(2)) / 2;
    EXPECT_LT(
        (again.position.col(split::n) - (before + Vector3d(run.frames[3].position.col(split::n))) / 2).norm(),
        1e-15);
    EXPECT_EQ(again.face_fragment, run.frames[3].face_fragment);
    EXPECT_EQ(again.edge_strain[15], (run.frames[2].edge_strain[7] + run.frames[3].edge_strain[15]) / 2)
        << "half of the edge 7";
}

TEST(SplitRecording, FramesInTheWrongOrderHaveNothingBetween) {
    const SyntheticRun run = split_run();
    EXPECT_THROW(interpolated(run.frames[3], run.frames[1], 0.5), Error);
}

/// Turns a recording of a run that split no face into one of version 2.
void make_version_2(const fs::path& file) {
    const hdf5::Handle opened = open_to_edit(file);
    for (std::size_t k = 0; k < hdf5::member_count(opened, "frames"); ++k)
        hdf5::remove(opened, recording_format::frame_group(k) + "/rest");
    for (const char* name : {"rest/vertex_parents", "rest/vertex_weights", "rest/face_parent",
                             "events/vertex_birth", "events/face_birth", "steps/exempt_pairs",
                             "steps/is_explicit", "steps/urgency", "steps/peak_yield"})
        hdf5::remove(opened, name);
    hdf5::write_attribute(opened, "format_version", std::int64_t{2});
}

TEST(SplitRecording, Version2IsReadWithTheSameAnswers) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    fs::create_directory(folder.path / "new");
    fs::create_directory(folder.path / "old");
    for (const std::string age : {"new", "old"}) {
        const fs::path file = folder.path / age / "run.h5";
        record(run, file);
        if (age == "old") make_version_2(file);
        for (std::size_t k = 0; k < 3; ++k) expect_same(Recording(file).frame(k), run.frames[k]);
        for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
                 {"plot", "run.h5"},
                 {"view", "run.h5"},
                 {"export", "run.h5", "--to", "obj", "--solid"},
                 {"export", "run.h5", "--to", "glb", "--animate", "morph"},
                 {"export", "run.h5", "--to", "pc2", "-o", "cache.pc2"},
                 {"export", "run.h5", "--to", "pvd"},
                 {"render", "run.h5", "-o", "run.png", "--size", "64x36", "--samples", "1"}}) {
            const ProgramResult result = run_sherd(command, file.parent_path());
            EXPECT_EQ(result.exit_code, 0) << command[0] << ": " << result.err;
        }
    }
    const auto contents = folder.contents();
    std::size_t compared = 0;
    for (const auto& [name, bytes] : contents)
        if (const fs::path path(name);
            path.parent_path().filename() == "new" && path.filename() != "run.h5") {
            EXPECT_TRUE(bytes == contents.at(folder.path / "old" / path.filename())) << path.filename();
            ++compared;
        }
    EXPECT_GE(compared, 10u);
    const auto info = [&](const std::string& age) {
        return run_info_json(read_run_info(folder.path / age / "run.h5"));
    };
    EXPECT_EQ(info("old"), info("new"));
}

/// Applies `damage` to a recording of the split run. Returns the error of reading a frame from it.
template <class Damage>
std::string error_after(Damage damage, std::size_t frame = 3) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "split.h5";
    record(split_run(), file);
    damage(static_cast<hid_t>(open_to_edit(file)));
    try {
        Recording(file).frame(frame);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, Fault::input);
        EXPECT_LE(run_sherd({"info", "split.h5"}, folder.path).exit_code, 2) << "no crash";
        EXPECT_EQ(run_sherd({"export", "split.h5", "--to", "glb"}, folder.path).exit_code, 2);
        return error.what();
    }
    return "";
}

template <class T>
void replace(hid_t file, const std::string& name, const std::vector<T>& values) {
    hdf5::remove(file, name);
    hdf5::write<T>(file, name, values, {});
}

void expect_word(const std::string& text, const std::string& word) {
    EXPECT_NE(text.find(word), std::string::npos) << text << " does not say " << word;
}

TEST(SplitRecording, NamesTheArrayThatIsDamaged) {
    const std::string group = "frames/000003/rest/";
    for (const std::string name :
         {"position", "faces", "area", "thickness", "vertex_parents", "vertex_weights", "face_parent"}) {
        expect_word(error_after([&](hid_t file) { hdf5::remove(file, group + name); }), "rest/" + name);
        expect_word(error_after([&](hid_t file) {
                        hdf5::remove(file, group + name);
                        hdf5::write_text(file, group + name, "text");
                    }),
                    "rest/" + name);
    }
    using Places = std::vector<Vector3d>;
    using Rows = std::vector<std::array<Index, 3>>;
    using Weights = std::vector<std::array<double, 3>>;
    const RestMesh rest = split_run().frames[3].rest;
    const auto expect_damage = [&](const std::string& name, const auto& values, const std::string& word) {
        expect_word(error_after([&](hid_t file) { replace(file, group + name, values); }), word);
    };
    expect_damage("position", Places(5, Vector3d::Zero()), "rest/position");
    expect_damage("area", std::vector<double>(8, 1.0), "rest/area");
    expect_damage("thickness", std::vector<double>(), "rest/thickness");
    expect_damage("face_parent", std::vector<Index>(8, 0), "rest/face_parent");
    for (const Index bad : {-1, 3, 1 << 30}) {
        std::vector<Index> parents = rest.face_parent;
        parents[8] = bad;
        expect_damage("face_parent", parents, "rest/face_parent");
    }
    for (const Index bad : {-1, 5, 11, 1 << 30}) {
        Rows rows = rest.vertex_parents;
        rows[9][2] = bad;
        expect_damage("vertex_parents", rows, "rest/vertex_parents");
        rows = rest.faces;
        rows[8][1] = bad;
        expect_damage("faces", rows, "rest/faces");
    }
    for (const double bad : {0.7, -0.25, std::nan("")}) {
        Weights weights = rest.vertex_weights;
        weights[9][0] = bad;
        expect_damage("vertex_weights", weights, "rest/vertex_weights");
    }
    Rows elsewhere = rest.vertex_parents;
    elsewhere[9] = {0, 1, 2};
    expect_damage("vertex_parents", elsewhere, "rest/vertex_parents");
    Rows others = rest.faces;
    std::swap(others[7], others[8]);
    expect_damage("faces", others, "rest/faces");
}

// The link to a mesh at rest may lead to nothing, in a circle, or to another object.
TEST(SplitRecording, NamesALinkThatLeadsNowhere) {
    const std::string link = "frames/000004/rest";
    for (const std::string target : {"/frames/000009/rest", "/frames/000004/rest", "/events", "/scene"})
        expect_word(error_after(
                        [&](hid_t file) {
                            hdf5::remove(file, link);
                            hdf5::create_link(file, link, target);
                        },
                        4),
                    "rest");
    expect_word(error_after([&](hid_t file) { hdf5::remove(file, link); }, 4), "rest");
}

TEST(SplitRecording, VerticesMustBeCopiesOfOnesThatExist) {
    for (const Index bad : {-1, 11}) {
        std::vector<Index> original = split::originals(11);
        original[10] = bad;
        expect_word(
            error_after([&](hid_t file) { replace(file, "frames/000003/vertex/original", original); }),
            "vertex/original");
    }
}

TEST(SplitRecording, TheWriterRefusesAMeshAtRestThatContradictsItself) {
    const TemporaryDirectory folder;
    const SyntheticRun run = split_run();
    RecordingWriter writer(folder.path / "split.h5", run.header, false);
    Snapshot broken = run.frames[1];
    broken.rest.vertex_weights[split::m] = {0.5, 0.25, 0};
    EXPECT_THROW(writer.append(broken, {}, {}), Error);
    broken = run.frames[1];
    broken.rest.unfractured_faces[2] = {4, 2, 1};
    EXPECT_THROW(writer.append(broken, {}, {}), Error) << "of another unbroken mesh";
    EXPECT_EQ(Recording(folder.path / "split.h5").frame_count(), 0u);
}

}  // namespace
}  // namespace sherd::test
