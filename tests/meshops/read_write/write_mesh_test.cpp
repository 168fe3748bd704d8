// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/write_mesh.h"

#include <gtest/gtest.h>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/topology/components.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

Mesh read(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    Mesh mesh = read_mesh(file, {.join_advice = ""}, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    return mesh;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Two triangles with a common edge, with texture.
TriangleSheet two_triangles() {
    TriangleSheet sheet;
    sheet.points = {{0, 0, 0}, {1.0 / 3, 0, 1e-300}, {1, 1, 0}, {0, 0.1, -2.5}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Eigen::Vector2d a(0, 0), b(1.0 / 3, 0), c(1, 1);
    sheet.look.texture = {{a, b, c}, {a, c, b}};
    return sheet;
}

// A sheet that is exported and read again must be the same to the last bit.
TEST(WriteMesh, ReadsBackBitForBit) {
    const test::TemporaryDirectory directory;
    const Mesh mesh = generate_sphere(0.1, {0.02, Layout::delaunay, 3});
    const TriangleSheet sheet = triangle_sheet(mesh);
    ASSERT_EQ(sheet.triangles.size(), mesh.number_of_faces());
    for (const char* name : {"a.obj", "a.ply", "a.PLY"}) {
        write_mesh(sheet, directory.path / name);
        const TriangleSheet again = triangle_sheet(read(directory.path / name));
        EXPECT_EQ(again.points, sheet.points);
        EXPECT_EQ(again.triangles, sheet.triangles);
    }
    EXPECT_EQ(directory.contents().size(), 3U);  // no temporary file is left behind
}

TEST(WriteMesh, KeepsTextureAndExtremeNumbersInObj) {
    const test::TemporaryDirectory directory;
    const TriangleSheet sheet = two_triangles();
    write_mesh(sheet, directory.path / "a.obj");
    const TriangleSheet again = triangle_sheet(read(directory.path / "a.obj"));
    EXPECT_EQ(again.points, sheet.points);
    EXPECT_EQ(again.look.texture, sheet.look.texture);
}

// Programs that read objects assume that each object has its own points.
TEST(WriteMesh, MakesAnObjObjectOfEachGroup) {
    const test::TemporaryDirectory directory;
    TriangleSheet sheet = two_triangles();
    sheet.look.texture.clear();
    sheet.points[3] = {0, 1, 0};
    sheet.points[1] = {1, 0, 0};
    sheet.group = {1, 0};
    sheet.group_names = {"fragment_0", "fragment_1", "empty"};
    write_mesh(sheet, directory.path / "a.obj");
    EXPECT_EQ(text_of(directory.path / "a.obj"),
              "o fragment_0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n"
              "o fragment_1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 4 5 6\n");
    EXPECT_EQ(connected_components(read(directory.path / "a.obj")).count, 2);
}

TEST(WriteMesh, WritesEveryPropertyToPly) {
    const test::TemporaryDirectory directory;
    TriangleSheet sheet = two_triangles();
    sheet.group = {0, 1};
    sheet.group_names = {"a", "b"};
    sheet.quality = {0.5, 0.25};
    write_mesh(sheet, directory.path / "a.ply");
    const std::string text = text_of(directory.path / "a.ply");
    for (const char* line :
         {"property int fragment\n", "property double quality\n", "property list uchar float texcoord\n"}) {
        EXPECT_NE(text.find(line), std::string::npos) << line;
    }
    // header, points, and for each triangle: 3 and its points, fragment, quality, 6 and texture
    EXPECT_EQ(text.size(), text.find("end_header\n") + 11 + 4 * 24 + 2 * (1 + 12 + 4 + 8 + 1 + 24));
    EXPECT_EQ(triangle_sheet(read(directory.path / "a.ply")).triangles, sheet.triangles);
}

TEST(WriteMesh, SaysWhyItCannotWriteAndLeavesWhatWasThere) {
    const test::TemporaryDirectory directory;
    const auto before = directory.write("a.obj", "old");
    const auto expect_run_fault = [](const TriangleSheet& sheet, const std::filesystem::path& file) {
        try {
            write_mesh(sheet, file);
            ADD_FAILURE() << "wrote " << file;
        } catch (const Error& error) {
            EXPECT_EQ(error.fault, Fault::run);
            EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
        }
    };
    TriangleSheet broken = two_triangles();
    broken.triangles[1][2] = 4;
    expect_run_fault(broken, before);
    broken = two_triangles();
    broken.group = {0, 1};
    broken.group_names = {"only one"};
    expect_run_fault(broken, before);
    broken.group = {0};
    expect_run_fault(broken, before);
    EXPECT_EQ(text_of(before), "old");
    expect_run_fault(two_triangles(), directory.path / "missing" / "a.obj");
    expect_run_fault(two_triangles(), directory.path / "a.gltf");
    std::filesystem::create_directory(directory.path / "b.ply");
    expect_run_fault(two_triangles(), directory.path / "b.ply");
    EXPECT_EQ(directory.contents().size(), 2U);
}

// Writing to a full disk must not look like success.
TEST(WriteMesh, NoticesAFullDisk) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const test::TemporaryDirectory directory;
    std::filesystem::create_symlink("/dev/full", directory.path / "a.ply.part");
    EXPECT_THROW(write_mesh(two_triangles(), directory.path / "a.ply"), Error);
    EXPECT_FALSE(std::filesystem::exists(directory.path / "a.ply"));
}

}  // namespace
}  // namespace sherd
