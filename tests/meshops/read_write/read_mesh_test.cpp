// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/read_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <iostream>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_quality.h"
#include "tests/support/mesh/mesh_reading.h"

namespace sherd {
namespace {

using ReadMesh = test::MeshReading;
using test::area, test::triangles, test::Triangles;

using test::repair;
const std::string square_off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 2 0 1\n3 0 2 3\n";
const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
const std::string square_ply = ply_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 2 0 1\n3 0 2 3\n";
const std::string square_stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "a\n";

std::string binary_stl(const std::vector<float>& corners, std::uint32_t count) {
    std::string bytes(80, ' ');
    bytes.replace(0, 5, "solid");  // as some programs begin binary files, too
    const auto append = [&](std::uint32_t word) {
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * i & 255);
    };
    append(count);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i % 9 == 0) {
            for (int k = 0; k < 3; ++k) append(0);
        }
        append(std::bit_cast<std::uint32_t>(corners[i]));
        if (i % 9 == 8) bytes += std::string(2, '\0');
    }
    return bytes;
}

// Scenes refer to faces and vertices of a file by number (pins, textures, edges to cut), in this order.
TEST_F(ReadMesh, KeepsTheOrderOfFacesAndCorners) {
    const Triangles expected{{2, 0, 1}, {0, 2, 3}};
    EXPECT_EQ(triangles(read("a.obj", test::square + "f 3 1 2\nf 1 3 4\n")), expected);
    EXPECT_EQ(triangles(read("a.off", square_off)), expected);
    EXPECT_EQ(triangles(read("a.ply", square_ply)), expected);
    EXPECT_EQ(triangles(read("a.stl", square_stl)), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(ReadMesh, ReadsBinaryStlAndJoinsItsPoints) {
    const std::vector<float> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0};
    const Mesh mesh = read("a.STL", binary_stl(corners, 2));
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.number_of_vertices(), 4U);
    EXPECT_TRUE(warnings.empty());
    expect_failure("b.stl", binary_stl(corners, 3), "truncated");
    std::vector<float> bad = corners;
    bad[4] = std::nanf("");
    expect_failure("c.stl", binary_stl(bad, 2), "face 0: coordinate y of its corner 1 is NaN or infinite");
}

TEST_F(ReadMesh, ReadsWhatObjFilesHold) {
    const Mesh mesh =
        read("a.obj",
             "\r\n# comment\r\nmtllib x.mtl\r\no thing\r\nv +0 0 0 1\r\nv 1.0e0 0 0 0.5 0.5 0.5\r\n"
             "v 1 1 0\r\nvt 0.25 0.5\r\nvt 1 0\r\nvt 1 1 0\r\nvn 0 0 1\r\ns off\r\nusemtl y\r\n"
             "f -3/-3/1 -2/-2/1 \\\r\n -1/-1/1\r\nv 0 1 0\r\nl 1 2\r\nf 1/1 3/3 4/2 # end");
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const auto [texture, exists] = find_property(mesh, attribute::texture);
    ASSERT_TRUE(exists);
    EXPECT_EQ(texture[Face(0)][0], Eigen::Vector2d(0.25, 0.5));
    EXPECT_EQ(texture[Face(0)][1], Eigen::Vector2d(1, 0));
    EXPECT_EQ(texture[Face(1)][2], Eigen::Vector2d(1, 0));
}

// For a name that is too long the system reports another error than for a missing file: it must give the
// same warning.
TEST_F(ReadMesh, TellsOfMaterialsWhoseNameIsTooLong) {
    const std::string library = "mtllib " + std::string(300, 'm') + "\n" + test::square;
    read("a.obj", library + "usemtl red\nf 1 2 3\nf 1 3 4\n");
    expect_warning("mmm' does not exist; its materials have names only");
    read("b.obj", library + "f 1 2 3\nf 1 3 4\n");
    EXPECT_TRUE(warnings.empty()) << "it has no materials that could miss it";
}

TEST_F(ReadMesh, HasNoTextureWhereTheFileHasNone) {
    const Mesh bare = read("a.obj", test::square + "f 1//1 2//1 3//1\n f 1 3 4\n");
    EXPECT_FALSE((find_property(bare, attribute::texture).second));
    read("b.obj", test::square + "vt 1 1\nf 1/1 2/1 3/1\nf 1 3 4\n");
    expect_warning("1 face was given texture coordinates (0, 0)");
}

TEST_F(ReadMesh, TriangulatesPolygons) {
    EXPECT_NEAR(area(read("quad.obj", test::square + "f 1 2 3 4\n")), 1, 1e-15);
    // An arrowhead: only the diagonal from its notch lies inside, though it may not be the shorter.
    const std::string arrow = "v 0 0 0\nv 2 3 0\nv 0 1 0\nv -2 3 0\n";
    for (const char* face : {"f 1 2 3 4", "f 2 3 4 1", "f 4 3 2 1"}) {
        const Mesh mesh = read("arrow.obj", arrow + face);
        EXPECT_EQ(mesh.number_of_faces(), 2U);
        EXPECT_NEAR(area(mesh), 2, 1e-14);
    }
    // The letter U, upright in space: a fan would cover its gap.
    const Mesh u = read("u.obj",
                        "v 0 0 0\nv 0 3 0\nv 0 3 3\nv 0 2 3\nv 0 2 1\nv 0 1 1\nv 0 1 3\nv 0 0 3\nv 5 5 5\n"
                        "v 6 5 5\nv 6 6 5\nf 1 2 3 4 5 6 7 8\nf 9 10 11\n");
    EXPECT_EQ(u.number_of_faces(), 7U);
    EXPECT_NEAR(area(u), 7.5, 1e-14);
    EXPECT_EQ(triangles(u).back(), (std::vector<unsigned>{8, 9, 10}));
    // Corners in the middle of a side must not cause triangles of zero area.
    const Mesh side = read("side.obj", test::square + "v 0.5 0 0\nv 0.5 1 0\nf 1 5 2 3 6 4\n");
    EXPECT_EQ(side.number_of_faces(), 4U);
    EXPECT_GT(test::mesh_quality(side).smallest_angle, 20);
    // A bent polygon: its two halves are planar, the whole is not.
    EXPECT_EQ(read("bent.obj", test::square + "v 0.5 -0.5 1\nf 1 5 2 3 4\n").number_of_faces(), 3U);
    // A hole that is connected by a bridge in both directions, as CAD programs write faces with holes.
    const std::string ring = test::square + "v 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 2 0\nv 2 1 0\nv 2 2 0\nv 1 1 0\n";
    for (const char* face : {"f 1 5 6 7 1 11 8 10 9 11", "f 11 9 10 8 11 1 7 6 5 1"}) {
        const Mesh mesh = read("ring.obj", ring + face);
        EXPECT_EQ(mesh.number_of_faces(), 8U);
        EXPECT_NEAR(area(mesh), 8, 1e-14);
    }
    expect_failure("eight.obj", test::square + "v 2 0 0\nv 2 2 0\nf 1 3 4 1 5 6\n", "crosses");
    expect_failure("bow.obj", test::square + "f 1 2 4 3\n", "crosses or touches itself");
    expect_failure("star.obj", "v 0 0 0\nv 4 3 0\nv 0 3 0\nv 4 0 0\nv 2 5 0\nf 1 2 3 4 5\n", "crosses");
    // Two sides run back along other sides, so that the number of triangles between the sides is that of a
    // valid polygon.
    expect_failure("spikes.obj", "v 0 0 0\nv 2 0 0\nv 1 0 0\nv 1 1 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4 5 6\n",
                   "crosses");
    // The polygon is warped so much that one side is parallel to the axis nearest to the polygon's normal:
    // projected along this axis, the side has no length.
    expect_failure("folded.obj", "v 0 1 0\nv 0 0 0\nv 0 0 1\nv 1 1 1\nv 2 2 2\nv 3 2 2\nf 1 2 3 4 5 6\n",
                   "crosses");
}

TEST_F(ReadMesh, TurnsTheFewerFacesOver) {
    const std::string strip = test::square + "v 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    const Mesh mesh = read("a.obj", strip + "f 1/1 3/2 2/3\nf 1/1 3/1 4/1\nf 2/1 5/1 3/1\nf 5/1 6/1 3/1\n");
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {4, 5, 2}}));
    const auto texture = find_property(mesh, attribute::texture).first;
    EXPECT_EQ(texture[Face(0)][1], Eigen::Vector2d(0, 1));  // texture moves with the corner
    expect_warning("1 face was turned over");
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(ReadMesh, RefusesAMoebiusBand) {
    std::string band;
    constexpr int n = 8;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        for (const double side : {-0.3, 0.3}) {
            const double r = 1 + side * std::cos(angle / 2);
            band += "v " + std::to_string(r * std::cos(angle)) + " " + std::to_string(r * std::sin(angle)) +
                    " " + std::to_string(side * std::sin(angle / 2)) + "\n";
        }
    }
    for (int i = 0; i < n; ++i) {
        const int a = 2 * i + 1, b = a + 1, c = i + 1 < n ? a + 2 : 2, d = i + 1 < n ? a + 3 : 1;
        for (const auto& [p, q, r] : {std::array{a, c, d}, std::array{a, d, b}}) {
            band += "f " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + "\n";
        }
    }
    expect_failure("moebius.obj", band, "only one side");
    expect_failure("moebius.obj", band, "only one side", repair);
}

TEST_F(ReadMesh, DropsUnreferencedVertices) {
    const Mesh mesh = read("a.obj", "v 9 9 9\n" + test::square + "v 8 8 8\nf 2 3 4\nf 2 4 5\n");
    EXPECT_EQ(mesh.number_of_vertices(), 4U);
    EXPECT_EQ(triangles(mesh), (Triangles{{1, 2, 3}, {1, 3, 4}}));
    expect_warning("2 vertices were dropped that no face uses");
}

TEST_F(ReadMesh, JoinsDuplicatePointsOnRequestOnly) {
    const std::string text = test::square + "v 0 0 -0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n";
    EXPECT_EQ(connected_components(read("a.obj", text)).count, 2);
    const Mesh joined = read("a.obj", text, {true});
    EXPECT_EQ(connected_components(joined).count, 1);
    EXPECT_EQ(triangles(joined), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    expect_warning("2 vertices were joined");
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(ReadMesh, NamesTheZeroAreaTriangleOrDropsIt) {
    for (const char* face : {"f 1 1 2", "f 1 5 2", "f 2 3 3"}) {
        const std::string text = test::square + "v 0.5 0 0\nf 1 2 3\n" + face + "\nf 1 3 4\n";
        expect_failure("a.obj", text, "a.obj:7: face 1: the triangle of vertices ");
        expect_failure("a.obj", text, "zero area; `repair = true`");
        const Mesh mesh = read("a.obj", text, repair);
        EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
        expect_warning("1 triangle was dropped for zero area");
    }
    expect_failure("a.obj", test::square + "f 1 2 2 3\n", "zero area");
    EXPECT_EQ(read("a.obj", test::square + "f 1 2 2 3 4\n", repair).number_of_faces(), 2U);
    expect_failure("a.obj", test::square + "f 1 1 1\n", "no faces left", repair);
    expect_failure("a.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n",
                   "face 0: the triangle of vertices 0, 1 and 2");
}

TEST_F(ReadMesh, NamesTheNonManifoldEdgeOrSeparatesIt) {
    // Three leaves of a book.
    const std::string book = test::square + "v 0.5 0.5 1\nf 1 2 3\nf 1 3 4\nf 1 3 5\n";
    expect_failure("a.obj", book, "a.obj:8: face 2: non-manifold edge: 3 faces (0, 1, 2)");
    expect_failure("a.obj", book, "vertices 0 and 2 at (0.5, 0.5, 0)");
    const Mesh mesh = read("a.obj", book, repair);
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}));
    EXPECT_EQ(connected_components(mesh).count, 2) << "the two leaves that lie flat are one sheet";
    EXPECT_TRUE(mesh.is_valid(false));
    expect_warning("1 non-manifold edge was separated");
}

// Both ends of the non-manifold edge are joined all round by other faces: cutting at the edge alone would
// not suffice.
TEST_F(ReadMesh, SeparatesAWingOnAClosedSurface) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 -1\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 2 3 5\n";
    EXPECT_NE(failure("a.obj", text).find("non-manifold edge"), std::string::npos);
    const Mesh mesh = read("a.obj", text, repair);
    EXPECT_EQ(mesh.number_of_faces(), 5U);
    EXPECT_TRUE(mesh.is_valid(false));
    EXPECT_EQ(connected_components(mesh).count, 2);
    EXPECT_EQ(mesh.number_of_vertices(), 7U);
}

// Two closed tetrahedra with a common edge, which has four faces: each must become a surface of its own.
TEST_F(ReadMesh, SeparatesSolidsThatShareAnEdge) {
    const Mesh mesh = read("a.obj",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\n"
                           "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 5 2\nf 1 2 6\nf 2 5 6\nf 5 1 6\n",
                           repair);
    EXPECT_EQ(mesh.number_of_faces(), 8U);
    EXPECT_TRUE(mesh.is_valid(false));
    EXPECT_EQ(connected_components(mesh).count, 2);
    for (const Edge edge : mesh.edges()) EXPECT_FALSE(mesh.is_border(edge)) << "the solids stay closed";
}

TEST_F(ReadMesh, SeparatesFansThatMeetInAPoint) {
    const Mesh mesh = read("a.obj", test::square + "v 2 1 0\nv 2 2 0\nf 1 2 3\nf 3 5 6\n");
    EXPECT_EQ(mesh.number_of_vertices(), 6U);
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {2, 4, 5}}));
    expect_warning("1 vertex was doubled");
    EXPECT_TRUE(mesh.is_valid(false));
}

TEST_F(ReadMesh, NamesARepeatedTriangleOrDropsIt) {
    const std::string text = test::square + "f 1 2 3\nf 1 3 4\nf 3 2 1\n";
    expect_failure("a.obj", text, "a.obj:7: face 2: the triangle of vertices 2, 1 and 0 at (0.6667, 0.333");
    EXPECT_EQ(read("a.obj", text, repair).number_of_faces(), 2U);
    expect_warning("1 triangle was dropped as repeated");
}

TEST_F(ReadMesh, RefusesIndicesOutOfRange) {
    expect_failure("a.obj", test::square + "f 1 2 5\n",
                   "a.obj:5: face 0: index out of range: there is no vertex 4");
    expect_failure("a.obj", test::square + "f 1 2 0\n", "a.obj:5: `0` index out of range");
    expect_failure("a.obj", test::square + "f 1 2 -5\n", "a.obj:5: `-5` index out of range");
    expect_failure("a.obj", test::square + "f 1/1 2/1 3/1\n", "a.obj:5: `1/1` names a texture point");
    expect_failure("a.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 4\n",
                   "face 1: index out of range: there is no vertex 4");
    expect_failure("b.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 -1\n",
                   "there is no vertex -1");
    expect_failure("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n", "a.off:6");
}

TEST_F(ReadMesh, RefusesCoordinatesThatAreNotFinite) {
    for (const char* bad : {"nan", "inf", "-inf", "NaN", "1e999"}) {
        const std::string line = std::string("v 0 ") + bad + " 0\n";
        expect_failure("a.obj", "v 0 0 0\n" + line + "v 1 1 0\nf 1 2 3\n",
                       "a.obj:2: vertex 1: a coordinate is NaN");
    }
    for (const char* bad : {"nan", "inf"}) {
        const std::string rows = std::string("0 0 0\n1 ") + bad + " 0\n1 1 0\n";
        expect_failure("a.off", "OFF\n3 1 0\n" + rows + "3 0 1 2\n",
                       "a.off:4: vertex 1: a coordinate is NaN or infinite");
        expect_failure("a.ply", ply_header + rows + "0 1 0\n3 0 1 2\n3 0 2 3\n",
                       "a.ply:11: vertex 1: a coordinate is NaN or infinite");
        std::string stl = square_stl;
        stl.replace(stl.find("vertex 1 0 0"), 12, std::string("vertex 1 ") + bad + " 0");
        expect_failure("a.stl", stl, "a.stl:5: vertex 1: a coordinate is NaN or infinite");
    }
}

TEST_F(ReadMesh, RefusesMeshesWithoutFaces) {
    expect_failure("a.obj", "", "no faces");
    expect_failure("a.obj", test::square, "no faces");
    expect_failure("a.off", "OFF\n1 0 0\n0 0 0\n", "no faces");
    expect_failure("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty "
                   "float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
                   "no faces");
    expect_failure("a.stl", "solid a\nendsolid a\n", "no faces");
    expect_failure("b.stl", binary_stl({}, 0), "no faces");
    expect_failure("a.obj", test::square + "f 1 2\n", "a.obj:5: face 0: has 2 corners");
}

// Damaged files must give a message, and never a crash, a hang or half a mesh.
TEST_F(ReadMesh, RefusesDamagedFiles) {
    std::string junk;
    for (int i = 0; i < 5000; ++i) junk += static_cast<char>(i * 7919 % 251);
    for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
        expect_failure(name, junk, name);
        expect_failure(name, std::string(300, '\xff'), name);
    }
    for (const char* name : {"e.off", "e.ply", "e.stl"}) expect_failure(name, "", name);
    for (const auto& [name, text] : {std::pair{"a.off", square_off}, {"a.ply", square_ply}}) {
        // Truncated anywhere before the last number, the file is incomplete.
        for (std::size_t size = 0; size + 2 < text.size(); ++size) {
            EXPECT_NE(failure(name, text.substr(0, size)), "no error") << name << " of " << size << " bytes";
        }
    }
    for (std::size_t size = 0; size + 3 < square_stl.size(); ++size) {
        EXPECT_NE(failure("a.stl", square_stl.substr(0, size)), "no error") << size;
    }
    expect_failure("huge.off", "OFF\n900000000 1 0\n0 0 0\n", "truncated");
    expect_failure("word.obj", "v 0 0 zero\n", "word.obj:1: `zero` is not a number");
    expect_failure("short.obj", "\nv 0 0\n", "short.obj:2: a coordinate is missing");
    expect_failure("face.obj", test::square + "f 1 2 x\n", "face.obj:5: `x` is not a vertex number");
}

TEST_F(ReadMesh, RefusesWhatIsNoMeshFile) {
    expect_failure("a.gltf", "{}", "known are .obj, .ply, .off and .stl");
    expect_failure("noextension", "", "unknown kind");
    EXPECT_THROW(read_mesh(directory.path / "missing.obj", {}, warnings), Error);
    std::filesystem::create_directory(directory.path / "folder.obj");
    try {
        read_mesh(directory.path / "folder.obj", {}, warnings);
        ADD_FAILURE() << "read a folder";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("is a folder"), std::string::npos);
    }
}

/// Folder with real meshes that are not part of the project.
std::filesystem::path shared_meshes() {
    if (const char* folder = std::getenv("SHERD_TEST_MESHES")) return folder;
    return std::filesystem::path(__FILE__).parent_path() / "../../../shared/data";
}

// Files of modelling programs differ from files that were written for tests.
TEST(ReadRealMeshes, AreManifoldsWithTheirAreaKept) {
    if (!std::filesystem::is_directory(shared_meshes())) {
        GTEST_SKIP() << "NO REAL MESHES READ: set SHERD_TEST_MESHES to a folder that has some";
    }
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shared_meshes())) {
        const auto extension = entry.path().extension();
        if (extension != ".obj" && extension != ".ply" && extension != ".off" && extension != ".stl")
            continue;
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(entry.path(), {false, Repair::all}, warnings);
        EXPECT_TRUE(mesh.is_valid(false));
        EXPECT_GT(test::mesh_quality(mesh).area, 0);
        std::cout << entry.path().filename().string() << ": " << mesh.number_of_vertices() << " vertices, "
                  << mesh.number_of_faces() << " faces, " << connected_components(mesh).count
                  << " components\n";
        for (const auto& warning : warnings) std::cout << "    " << warning << "\n";
        ++count;
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace sherd
