// SPDX-License-Identifier: GPL-3.0-or-later
// Exported level sets, read back by OpenVDB.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>

#include "tests/support/program/program.h"
#include "tests/support/recording/export_fixture.h"

namespace sherd::test {
namespace {

// The level set of two sheets, 1 mm and 2 mm thick, must be negative inside them and nowhere else.
TEST_F(Export, VdbIsTheSheetWithItsThickness) {
    for (auto& frame : run.frames) frame.position.row(2).setZero();
    record(run, folder.path / "flat.h5");
    ExportOptions wanted = options("vdb", "out.vdb");
    wanted.recording = folder.path / "flat.h5";
    export_recording(wanted);
    openvdb::initialize();
    openvdb::io::File file((folder.path / "out.vdb").string());
    file.open();
    const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("surface"));
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
    EXPECT_NEAR(grid->voxelSize()[0], 0.25e-3, 1e-12);
    const auto at = [&](double x, double y, double z) {
        return grid->tree().getValue(grid->transform().worldToIndexCellCentered({x, y, z}));
    };
    EXPECT_NEAR(at(0.03, 0.02, 0), -0.5e-3, 1e-6) << "1 mm: the first half of the faces";
    EXPECT_NEAR(at(0.03, 0.02, 0.5e-3), 0, 1e-6);
    EXPECT_NEAR(at(0.03, 0.02, -0.75e-3), 0.25e-3, 1e-6);
    EXPECT_NEAR(at(0.09, 0.02, 0), -1e-3, 1e-6) << "2 mm: the second";
    EXPECT_NEAR(at(0.09, 0.02, 1.25e-3), 0.25e-3, 1e-6);
    EXPECT_NEAR(at(0.09, 0.02, 0.02), 0.75e-3, 1e-6) << "three voxels, far outside";
    export_recording([&] {
        wanted.output = folder.path / "again.vdb";
        return wanted;
    }());
    EXPECT_EQ(bytes("out.vdb"), bytes("again.vdb"));
}

// On a full disk OpenVDB itself would write half a file without an error.
TEST_F(Export, VdbThatFindsNoRoomIsAnError) {
    const ProgramResult result =
        run_sherd({"export", "run.h5", "--to", "vdb"}, folder.path, {.file_bytes = 5000});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("no room"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path / "run.vdb"));
    EXPECT_FALSE(std::filesystem::exists(folder.path / "run.vdb.part"));
}

TEST_F(Export, RefusesVoxelsThatMakeNoSense) {
    const auto before = folder.contents();
    ExportOptions wanted = options("vdb", "out.vdb");
    for (const double bad : {0.0, -1.0, std::nan(""), 0.6e-3, 1e-7}) {
        wanted.voxel = bad;
        EXPECT_NE(error_of(wanted).find("voxel"), std::string::npos) << bad;
    }
    EXPECT_EQ(folder.contents(), before);
}

}  // namespace
}  // namespace sherd::test
