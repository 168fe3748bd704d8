// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <set>

#include "app/recording/hdf5.h"
#include "app/recording/hdf5_file.h"
#include "meshops/error.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/program/file_size_limit.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/same_report.h"
#include "tests/support/recording/same_snapshot.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Expects the content of `file` after the first `frames` appends of `run`.
void expect_recorded(const fs::path& file, const SyntheticRun& run, std::size_t frames) {
    const Recording recording(file);
    ASSERT_EQ(recording.frame_count(), frames);
    std::vector<StepReport> steps;
    CrackEvents events;
    for (std::size_t k = 0; k < frames; ++k) {
        test::expect_same(recording.frame(k), run.frames[k]);
        steps.insert(steps.end(), run.steps[k].begin(), run.steps[k].end());
        append(events, run.events[k]);
    }
    const std::vector<StepReport> recorded = recording.steps();
    ASSERT_EQ(recorded.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) expect_same(recorded[i], steps[i]);
    expect_same(recording.events(), events);
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
}

template <class Action>
void expect_error(Action action, Fault fault, const std::vector<std::string>& words) {
    try {
        action();
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, fault) << error.what();
        for (const std::string& word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(Recording, KeepsEveryBit) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    record(run, folder.path / "run.h5");
    expect_recorded(folder.path / "run.h5", run, 3);
    const Recording recording(folder.path / "run.h5");
    const RecordingHeader header = recording.header();
    EXPECT_EQ(header.scene_file, run.header.scene_file);
    EXPECT_EQ(header.scene_text, run.header.scene_text);
    EXPECT_EQ(header.seed, run.header.seed);
    EXPECT_EQ(header.sheet_names, run.header.sheet_names);
    EXPECT_TRUE(same(header.rest_position, run.header.rest_position));
    EXPECT_TRUE(same(header.rest_faces, run.header.rest_faces));
    EXPECT_TRUE(same(header.rest_area, run.header.rest_area));
    EXPECT_TRUE(same(header.rest_thickness, run.header.rest_thickness));
    ASSERT_EQ(header.supports.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(header.supports[i].name, run.header.supports[i].name);
        EXPECT_EQ(header.supports[i].kind, run.header.supports[i].kind);
    }
    ASSERT_EQ(header.gauges.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(header.gauges[i].name, run.header.gauges[i].name);
        EXPECT_EQ(header.gauges[i].sheet, run.header.gauges[i].sheet);
        EXPECT_EQ(header.gauges[i].place, run.header.gauges[i].place);
    }
    EXPECT_EQ(recording.wall_seconds(), 12.5);
    EXPECT_EQ(recording.end(), "complete");
    EXPECT_EQ(names_in(folder.path), (std::set<std::string>{"run.h5", "run.xdmf"}));
}

// Equal runs must give equal files, but by default HDF5 stores the time at which each dataset was made.
TEST(Recording, IsTheSameFileForTheSameRunAtAnotherTime) {
    const TemporaryDirectory folder;
    const std::time_t second = std::time(nullptr);
    record(synthetic_run(), folder.path / "a.h5");
    while (std::time(nullptr) == second) usleep(10'000);
    record(synthetic_run(), folder.path / "b.h5");
    auto contents = folder.contents();
    EXPECT_TRUE(contents[folder.path / "a.h5"] == contents[folder.path / "b.h5"]) << "bytes differ";
}

TEST(Recording, IsReadableBetweenAppends) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(folder.path / "run.h5", run.header, false);
    EXPECT_EQ(Recording(folder.path / "run.h5").end(), "running");
    for (std::size_t k = 0; k < 3; ++k) {
        expect_recorded(folder.path / "run.h5", run, k);
        writer.append(run.frames[k], run.steps[k], run.events[k]);
    }
    expect_recorded(folder.path / "run.h5", run, 3);
}

// The index is always written as a whole: a run that wrote it with each of thousands of frames would do
// little else.
TEST(Recording, IsIndexedWithEachFrameAtFirstThenWithEachHundredthPartMore) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(folder.path / "run.h5", run.header, false);
    const auto indexed = [&] {
        const std::string text = folder.contents().at(folder.path / "run.xdmf"), grid = "<Grid Name=\"edges ";
        std::size_t count = 0;
        for (auto at = text.find(grid); at != text.npos; at = text.find(grid, at + 1)) ++count;
        return count;
    };
    for (std::size_t frames = 1; frames <= 203; ++frames) {
        writer.append(run.frames[0], {}, {});
        if (frames == 1 || frames == 99 || frames == 200) {
            EXPECT_EQ(indexed(), frames);
        }
    }
    EXPECT_EQ(indexed(), 202u);
    writer.finish(1, "complete");
    EXPECT_EQ(indexed(), 203u);
}

TEST(Recording, DoesNotOverwriteUnlessForced) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    record(run, folder.path / "run.h5");
    const auto before = folder.contents();
    expect_error([&] { RecordingWriter(folder.path / "run.h5", run.header, false); }, Fault::input,
                 {"run.h5", "--force"});
    EXPECT_EQ(folder.contents(), before);
    { const RecordingWriter replaced(folder.path / "run.h5", run.header, true); }
    expect_recorded(folder.path / "run.h5", run, 0);
    EXPECT_EQ(names_in(folder.path), std::set<std::string>{"run.h5"}) << "the index of the old run is left";
    folder.write("other.xdmf", "somebody's");
    expect_error([&] { RecordingWriter(folder.path / "other.h5", run.header, false); }, Fault::input,
                 {"other.xdmf", "--force"});
}

TEST(Recording, LeavesNothingWhereItCannotBeCreated) {
    const TemporaryDirectory folder;
    folder.write("plain", "");
    fs::create_directory(folder.path / "folder.h5");
    const auto before = folder.contents();
    for (const std::string name : {"missing/run.h5", "plain/run.h5", "folder.h5", "run.xdmf"})
        expect_error([&] { RecordingWriter(folder.path / name, synthetic_run().header, true); }, Fault::input,
                     {name});
    EXPECT_EQ(folder.contents(), before);
}

TEST(Recording, SurvivesTheEndOfTheDiskAndGoesOnWhenThereIsRoomAgain) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(file, run.header, false);
    writer.append(run.frames[0], run.steps[0], run.events[0]);
    writer.append(run.frames[1], run.steps[1], run.events[1]);
    const auto before = folder.contents();
    {
        const FileSizeLimit limit(fs::file_size(file) + 5'000);
        expect_error([&] { writer.append(run.frames[2], run.steps[2], run.events[2]); }, Fault::run,
                     {"run.h5", "frame 2", "no room", "stay readable"});
    }
    EXPECT_EQ(folder.contents(), before);
    expect_recorded(file, run, 2);
    writer.append(run.frames[2], run.steps[2], run.events[2]);
    expect_recorded(file, run, 3);
}

// Times are sums of steps. With all their digits, as 0.00030000000000000003, they would hide what matters,
// and in statics they are no seconds.
TEST(Recording, NamesTheTimeOfAFrameThatFindsNoRoom) {
    for (const auto& [unit, words] :
         {std::pair{"s", "frame 0 (0.0003 s)"}, {"load", "frame 0 (load 0.0003)"}}) {
        const TemporaryDirectory folder;
        const fs::path file = folder.path / "run.h5";
        SyntheticRun run = synthetic_run();
        run.header.time_unit = unit;
        run.frames[0].time = 3 * 1e-4;
        RecordingWriter writer(file, run.header, false);
        const FileSizeLimit limit(fs::file_size(file) + 1'000);
        expect_error([&] { writer.append(run.frames[0], run.steps[0], run.events[0]); }, Fault::run,
                     {words, "no room"});
    }
}

// If HDF5 found the disk full in the middle of an append, the file would have a part of it.
TEST(Recording, AnAppendIsWholeOrNotAtAllWhereverTheDiskEnds) {
    const SyntheticRun run = synthetic_run();
    std::size_t whole = 0;
    for (std::uintmax_t room = 0; room <= 400'000; room += 20'000) {
        const TemporaryDirectory folder;
        const fs::path file = folder.path / "run.h5";
        RecordingWriter writer(file, run.header, false);
        const auto before = folder.contents();
        try {
            const FileSizeLimit limit(fs::file_size(file) + room);
            writer.append(run.frames[0], run.steps[1], run.events[2]);
            ++whole;
        } catch (const Error&) {
            EXPECT_EQ(folder.contents(), before) << room;
        }
        EXPECT_EQ(Recording(file).frame_count(), Recording(file).steps().empty() ? 0u : 1u) << room;
    }
    EXPECT_GT(whole, 0u);
    EXPECT_LT(whole, 21u);
}

TEST(Recording, CannotBeCreatedOnAFullDisk) {
    const TemporaryDirectory folder;
    const FileSizeLimit limit(10'000);
    expect_error([&] { RecordingWriter(folder.path / "run.h5", synthetic_run().header, false); }, Fault::run,
                 {"run.h5", "no room"});
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Recording, AChangeThatFailsHalfWayIsNone) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record(synthetic_run(), file);
    const std::string before = folder.contents().at(file);
    JournaledFile bytes(file);
    const auto remove_and_fail = [](hid_t opened) {
        hdf5::remove(opened, "frames/000001");
        hdf5::write_text(opened, "frames/000002/vertex", "in the way");
    };
    expect_error([&] { hdf5::change(bytes, remove_and_fail); }, Fault::run, {"frames/000002/vertex"});
    EXPECT_EQ(folder.contents().at(file), before);
    hdf5::change(bytes, [](hid_t opened) { hdf5::remove(opened, "frames/000002"); });
    EXPECT_EQ(Recording(file).frame_count(), 2u);
}

TEST(Recording, RefusesASnapshotThatContradictsItself) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(folder.path / "run.h5", run.header, false);
    Snapshot broken = run.frames[0];
    broken.velocity.conservativeResize(3, 4);
    expect_error([&] { writer.append(broken, {}, {}); }, Fault::run, {"differ in length"});
    broken = run.frames[0];
    broken.faces[5][1] = 65;
    expect_error([&] { writer.append(broken, {}, {}); }, Fault::run, {"vertex that does not exist"});
    expect_recorded(folder.path / "run.h5", run, 0);
}

/// Lock by which another program holds a file, as HDF5 sets it.
class Lock {
  public:
    Lock(const fs::path& file, int kind) : descriptor(open(file.c_str(), O_RDONLY)) {
        if (flock(descriptor, kind) != 0) throw std::runtime_error("cannot lock");
    }
    ~Lock() { close(descriptor); }

  private:
    int descriptor;
};

TEST(Recording, GoesOnBesideAReaderThatKeepsTheFileOpen) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(file, run.header, false);
    const Lock reader(file, LOCK_SH);
    writer.append(run.frames[0], run.steps[0], run.events[0]);
    expect_recorded(file, run, 1);
}

TEST(Recording, DoesNotWriteBesideAnotherWriter) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    const SyntheticRun run = synthetic_run();
    RecordingWriter writer(file, run.header, false);
    const auto before = folder.contents();
    {
        const Lock other(file, LOCK_EX);
        expect_error([&] { writer.append(run.frames[0], run.steps[0], run.events[0]); }, Fault::run,
                     {"run.h5", "another program"});
    }
    EXPECT_EQ(folder.contents(), before);
}

TEST(Recording, SaysWhatIsWrongWithAFileThatIsNoRecording) {
    const TemporaryDirectory folder;
    const auto opening = [&](const std::string& name) {
        return [=, &folder] { Recording(folder.path / name); };
    };
    expect_error(opening("missing.h5"), Fault::input, {"missing.h5", "there is no file"});
    expect_error(opening(std::string(300, 'a') + ".h5"), Fault::input,
                 {"aaa.h5", "File name too long", "path"});
    expect_error(opening("."), Fault::input, {"is not a file"});
    folder.write("text.h5", "not HDF5 at all");
    folder.write("empty.h5", "");
    expect_error(opening("text.h5"), Fault::input, {"text.h5", "not an HDF5 file"});
    expect_error(opening("empty.h5"), Fault::input, {"empty.h5", "not an HDF5 file"});
    H5Fclose(H5Fcreate((folder.path / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    expect_error(opening("foreign.h5"), Fault::input, {"foreign.h5", "not a recording"});
    record(synthetic_run(), folder.path / "newer.h5");
    hdf5::write_attribute(open_to_edit(folder.path / "newer.h5"), "format_version", std::int64_t{5});
    expect_error(opening("newer.h5"), Fault::input, {"newer.h5", "version 5", "versions 2 to 4"});
    const std::string whole = folder.contents().at(folder.path / "newer.h5");
    folder.write("cut.h5", whole.substr(0, whole.size() / 2));
    expect_error(opening("cut.h5"), Fault::input, {"cut.h5", "damaged"});
}

TEST(Recording, NamesWhatIsDamaged) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record(synthetic_run(), file);
    {
        const hdf5::Handle opened = open_to_edit(file);
        hdf5::remove(opened, "frames/000001/vertex/mass");
        hdf5::remove(opened, "steps/kinetic");
    }
    const Recording recording(file);
    EXPECT_EQ(recording.frame(0).faces.size(), 96u);
    expect_error([&] { recording.frame(1); }, Fault::input, {"run.h5", "damaged", "vertex/mass"});
    expect_error([&] { recording.steps(); }, Fault::input, {"run.h5", "damaged", "steps/kinetic"});
}

// An array that claims a million million values would take memory before a single value is read.
TEST(Recording, BelievesNoLengthThatItsBytesCannotHave) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    record(synthetic_run(), file);
    {
        const hdf5::Handle opened = open_to_edit(file);
        hdf5::remove(opened, "frames/000001/vertex/mass");
        const hsize_t rows = hsize_t{1} << 40, chunk = 128;
        const hdf5::Handle space(H5Screate_simple(1, &rows, nullptr)), layout(H5Pcreate(H5P_DATASET_CREATE));
        H5Pset_chunk(layout, 1, &chunk);
        const hdf5::Handle dataset(H5Dcreate2(opened, "frames/000001/vertex/mass", H5T_NATIVE_DOUBLE, space,
                                              H5P_DEFAULT, layout, H5P_DEFAULT));
        ASSERT_GE(static_cast<hid_t>(dataset), 0);
    }
    expect_error([&] { Recording(file).frame(1); }, Fault::input,
                 {"run.h5", "damaged", "vertex/mass", "promises more values than the file holds"});
}

// If this failed, fields would belong to other faces, or be missing in h5py.
TEST(Recording, KeepsFieldsOfFacesWithPrincipalValuesAndAxes) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    add_fields(run);
    record(run, folder.path / "run.h5");
    expect_recorded(folder.path / "run.h5", run, 3);
    const Recording recording(folder.path / "run.h5");
    EXPECT_TRUE(same(recording.fields(2).stress_bottom, run.frames[2].fields.stress_bottom));
    const RecordedGauge gauge = recording.header().gauges[0];
    EXPECT_FALSE(gauge.displacement);
    EXPECT_EQ(gauge.fields, (FaceFieldChoice{.stress = true, .membrane_strain = true}));
    EXPECT_EQ(gauge.axes, run.header.gauges[0].axes);
    EXPECT_TRUE(recording.header().gauges[1].displacement);
    EXPECT_FALSE(recording.header().gauges[1].fields.any());

    const hdf5::ReadableFile file(folder.path / "run.h5");
    EXPECT_FALSE(hdf5::contains(file, "gauges/tip/displacement"));
    EXPECT_FALSE(hdf5::contains(file, "gauges/middle/stress_top"));
    using Row = std::array<double, 6>;
    const auto axes = hdf5::read<Row>(file, "frames/000002/face/axes");
    const auto principal = hdf5::read<std::array<double, 2>>(file, "frames/000002/face/curvature_principal");
    const Snapshot& last = run.frames[2];
    ASSERT_EQ(axes.size(), last.faces.size());
    for (std::size_t f = 0; f < last.faces.size(); ++f) {
        const Vector3d side = last.position.col(last.faces[f][1]) - last.position.col(last.faces[f][0]);
        const Vector3d first(axes[f][0], axes[f][1], axes[f][2]), second(axes[f][3], axes[f][4], axes[f][5]);
        EXPECT_LT((first - side.normalized()).norm(), 1e-12);
        EXPECT_LT(std::abs(first.dot(second)), 1e-12);
        EXPECT_GE(principal[f][0], principal[f][1]);
        const Vector3d curvature = last.fields.curvature.col(static_cast<Eigen::Index>(f));
        EXPECT_NEAR(principal[f][0] + principal[f][1], curvature[0] + curvature[1],
                    1e-12 * curvature.cwiseAbs().maxCoeff());
    }
}

TEST(Recording, IsDamagedWhenAFieldIsNotOfItsFaces) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    add_fields(run);
    run.frames[0].fields.curvature.conservativeResize(3, 5);
    expect_error([&] { record(run, folder.path / "run.h5"); }, Fault::run,
                 {"face/vertices and face/curvature differ in length"});
}

// Directions of cracks are relative to the material's axes, which must be recorded. A run without axes must
// not have an array for them.
TEST(Recording, HasTheAxesOfTheMaterial) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    record(run, folder.path / "none.h5");
    EXPECT_TRUE(Recording(folder.path / "none.h5").header().rest_axis.empty());
    EXPECT_FALSE(hdf5::contains(hdf5::ReadableFile(folder.path / "none.h5"), "rest/axis"));
    for (std::size_t f = 0; f < run.header.rest_faces.size(); ++f)
        run.header.rest_axis.emplace_back(std::cos(0.1 * f), std::sin(0.1 * f), -0.0);
    record(run, folder.path / "run.h5");
    EXPECT_TRUE(same(Recording(folder.path / "run.h5").header().rest_axis, run.header.rest_axis));
    run.header.rest_axis.pop_back();
    record(run, folder.path / "damaged.h5");
    expect_error([&] { Recording(folder.path / "damaged.h5").header(); }, Fault::input,
                 {"/rest/faces and /rest/axis differ in length"});
}

}  // namespace
}  // namespace sherd::test
