// SPDX-License-Identifier: GPL-3.0-or-later
// If grids were read wrongly, a field from another program would arrive shifted, or a damaged file would not
// be noticed.
#include "meshops/level_set/float_grid.h"

#include <gtest/gtest.h>

#include <fstream>

#include "meshops/error.h"
#include "tests/support/mesh/vdb_file.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

double plane(double x, double y, double z) {
    return 1 + 2 * x - 3 * y + 0.5 * z;
}

const openvdb::CoordBBox block(openvdb::Coord(-10, -10, -2), openvdb::Coord(10, 10, 2));

openvdb::FloatGrid::Ptr plane_grid(const std::string& name) {
    return vdb_grid(name, 0.1, block, 7.0f, plane);
}

GridSamples sample(const std::filesystem::path& file, const std::string& name,
                   const std::vector<Vector3d>& points) {
    return sample_float_grid(file, name, points);
}

std::string message_of(const std::filesystem::path& file, const std::string& name = "") {
    return message_thrown_by([&] { sample(file, name, {Vector3d::Zero()}); });
}

class FloatGrid : public testing::Test {
  protected:
    void expect_message(const std::string& found, const std::string& wanted) {
        EXPECT_NE(found.find(wanted), std::string::npos) << found;
        EXPECT_EQ(found.find((directory.path / "a.vdb").string() + ": "), 0u) << found;
    }
    TemporaryDirectory directory;
    std::filesystem::path file = directory.path / "a.vdb";
};

TEST_F(FloatGrid, IsLinearBetweenVoxelsAndBackgroundOutside) {
    write_vdb(file, {plane_grid("strength")});
    const std::vector<Vector3d> points{
        {0, 0, 0}, {0.13, -0.57, 0.08}, {-0.999, 0.333, -0.1999}, {0, 0, 0.5}, {3, 0, 0}};
    const GridSamples samples = sample(file, "", points);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(samples.values[i], plane(points[i].x(), points[i].y(), points[i].z()), 1e-6);
    EXPECT_EQ(samples.values[3], 7);
    EXPECT_EQ(samples.values[4], 7);
    EXPECT_EQ(samples.background, 7);
    EXPECT_EQ(samples.outside, 2u);
}

TEST_F(FloatGrid, IsFoundByNameAmongOthers) {
    const auto zero = [](double, double, double) { return 0.25f; };
    openvdb::initialize();
    const auto vectors = openvdb::GridBase::createGrid(openvdb::Vec3SGrid::gridType());
    vectors->setName("v");
    write_vdb(file, {vectors, vdb_grid("low", 1, block, 0.0f, zero), plane_grid("plane")});
    EXPECT_EQ(sample(file, "low", {Vector3d::Zero()}).values[0], 0.25);
    EXPECT_EQ(sample(file, "plane", {Vector3d::Zero()}).values[0], 1);
    expect_message(message_of(file), "holds several float grids: name one of 'low', 'plane'");
    expect_message(message_of(file, "v"), "has no float grid 'v'; it has 'low', 'plane'");
    write_vdb(file, {vectors, plane_grid("plane")});
    EXPECT_EQ(sample(file, "", {Vector3d::Zero()}).values[0], 1) << "the only float grid";
    write_vdb(file, {vectors});
    expect_message(message_of(file), "holds no float grid");
}

// Blender and Houdini write half floats on request.
TEST_F(FloatGrid, MayBeStoredAsHalfFloats) {
    const auto grid = plane_grid("plane");
    grid->setSaveFloatAsHalf(true);
    write_vdb(file, {grid});
    EXPECT_NEAR(sample(file, "plane", {{0.13, -0.57, 0.08}}).values[0], plane(0.13, -0.57, 0.08), 2e-3);
}

TEST_F(FloatGrid, RefusesWhatIsNoVdbFile) {
    expect_message(message_of(file), "No such file");
    expect_message(message_of(directory.write("a.vdb", "no grid at all, but some words of text")),
                   "damaged OpenVDB file");
    expect_message(message_of(directory.write("a.vdb", "")), "ends early");
    EXPECT_NE(message_of(directory.path).find("is a folder"), std::string::npos);
}

// A truncated file must never give values: OpenVDB itself returns uninitialised memory.
TEST_F(FloatGrid, RefusesAFileCutShort) {
    for (const auto compression :
         {openvdb::io::COMPRESS_NONE, openvdb::io::COMPRESS_ZIP, openvdb::io::COMPRESS_BLOSC}) {
        openvdb::io::File writer(file.string());
        openvdb::initialize();
        writer.setCompression(compression | openvdb::io::COMPRESS_ACTIVE_MASK);
        writer.write(openvdb::GridPtrVec{plane_grid("plane")});
        writer.close();
        const std::string whole = directory.contents().at(file.string());
        ASSERT_EQ(sample(file, "", {Vector3d::Zero()}).values[0], 1);
        for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97)
            expect_message(message_of(directory.write("a.vdb", whole.substr(0, size))),
                           "damaged OpenVDB file");
        expect_message(message_of(directory.write("a.vdb", whole.substr(0, whole.size() - 1))),
                       "damaged OpenVDB file");
    }
}

// OpenVDB trusts the lengths of compressed data in a file: with a wrong length it would write past the end
// of its memory.
TEST_F(FloatGrid, RefusesLengthsThatOpenVdbBelieves) {
    openvdb::initialize();
    openvdb::io::File writer(file.string());
    writer.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
    writer.write(openvdb::GridPtrVec{plane_grid("plane")});
    writer.close();
    const std::string whole = directory.contents().at(file.string());
    // Data compressed by zlib begin with this letter, after their length in 8 bytes; a negative length says
    // that the data are not compressed.
    const std::string behind_length = std::string(6, '\0') + 'x';
    int lengths = 0;
    for (std::size_t at = 0; (at = whole.find(behind_length, at)) != std::string::npos; ++at, ++lengths) {
        std::string damaged = whole;
        damaged.replace(at - 2, 8, std::string("\0\0\xff\xff\xff\xff\xff\xff", 8));
        expect_message(message_of(directory.write("a.vdb", damaged)), "damaged OpenVDB file");
    }
    EXPECT_GT(lengths, 20);
}

}  // namespace
}  // namespace sherd::test
