// SPDX-License-Identifier: GPL-3.0-or-later
// Accepted PLY files, and messages for invalid ones. Without good messages a user would search a header of
// ten lines for a misspelt word, or the program would allocate a billion vertices that are not there.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/read_write/ply_header.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/write_mesh.h"
#include "meshops/soup/polygon_soup.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/replaced.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string points_of_header =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faces_of_header = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string good = "ply\nformat ascii 1.0\ncomment by hand\n" + points_of_header + faces_of_header +
                         "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

PolygonSoup parse(const std::string& content) {
    return parse_ply("a.ply", content);
}

std::string failure(const std::string& content) {
    return message_thrown_by([&] { check_polygon_soup(parse(content)); });
}

TEST(Ply, EachMistakeOfAHeaderIsNamedWithItsLine) {
    struct Case {
        std::string from, to, message;
    };
    for (const auto& [from, to, message] : std::vector<Case>{
             {"element vertex 3", "elment vertex 3", "a.ply:4: `elment` is no keyword of a PLY header"},
             {"element vertex 3", "comment element", "a.ply:5: `property` stands before any `element`"},
             {"element vertex 3", "element vertex three", "a.ply:4: `three` is no number of rows"},
             {"element vertex 3", "element vertex -3", "a.ply:4: `-3` is no number of rows"},
             {"element vertex 3", "element vertex", "a.ply:4: is no number of rows"},
             {"element vertex 3", "element vertex 3 4", "a.ply:4: `4` is one too many"},
             {"element vertex 3", std::string("element vert\0x 3", 16), "a.ply:4: element"},
             {"element face", "element vertex", "a.ply:8: `vertex` is declared twice"},
             {"property float y", "property float x", "a.ply:6: `x` is declared twice"},
             {"property float y", "property real y", "a.ply:6: `real` is no type of PLY"},
             {"property float y", "property float", "a.ply:6: the property has no name"},
             {"property float y", "property float w",
              "a.ply:4: element vertex of the PLY file needs a number `y`"},
             {"list uchar int", "list float int", "a.ply:9: `float` cannot be the type of a list's length"},
             {"list uchar int", "list uchar float",
              "a.ply:8: element face of the PLY file needs a list of vertex"},
             {"list uchar int", "int", "a.ply:8: element face of the PLY file needs a list of vertex"},
             {"format ascii 1.0", "format ascii 2.0", "a.ply:2: `2.0` is no known version"},
             {"format ascii 1.0", "format asci 1.0", "a.ply:2: `asci` is no format of PLY"},
             {"format ascii 1.0\n", "", "has no line `format`"},
             {"end_header\n", "", "a.ply:10: `0` is no keyword"},
             {"ply\n", "plyer\n", "a.ply:1: is not a PLY file"}}) {
        const std::string found = failure(replaced(good, from, to));
        if (to.find('\0') != to.npos)
            EXPECT_NE(found, "");
        else
            EXPECT_NE(found.find(message), std::string::npos) << "no '" << message << "' in: " << found;
    }
    EXPECT_EQ(failure(good), "no error");
}

// Counts in the header, or of a list, that exceed the file must not be trusted.
TEST(Ply, CountsAreHeldAgainstTheSizeOfTheFile) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        for (const char* count : {"1000", "4000000000", "18446744073709551615"}) {
            const std::string many =
                replaced(replaced(good, "ascii", format), "vertex 3", std::string("vertex ") + count);
            EXPECT_NE(
                failure(many).find("a.ply:4: the PLY file ends too early (truncated?): its header promises "),
                std::string::npos)
                << failure(many);
        }
    EXPECT_NE(failure(replaced(good, "3 0 1 2", "200 0 1 2"))
                  .find("a.ply:14: face 0: its list vertex_indices has 200 values, more"),
              std::string::npos);
    EXPECT_NE(failure(replaced(replaced(good, "uchar int", "int int"), "3 0 1 2", "-3 0 1 2"))
                  .find("has -3 values"),
              std::string::npos);
    EXPECT_NE(failure(replaced(good, "3 0 1 2", "300 0 1 2"))
                  .find("a.ply:14: `300` is no number of the type uchar"),
              std::string::npos);
    std::string huge = replaced(replaced(good, "ascii", "binary_little_endian"), "uchar", "uint");
    huge = huge.substr(0, huge.find("end_header\n") + 11) + std::string(36, '\0') + std::string(4, '\xff') +
           "12345678";
    EXPECT_NE(failure(huge).find("a.ply: face 0: its list vertex_indices has 4294967295 values"),
              std::string::npos)
        << failure(huge);
    // Rows without content take no space: any number of them is valid.
    EXPECT_EQ(failure(replaced(good, "end_header", "element nothing 18446744073709551615\nend_header")),
              "no error");
}

TEST(Ply, RowsOfATextAreNamedByTheirLine) {
    const PolygonSoup soup = parse(replaced(good, "1 0 0\n", "\n1 0\n0\n"));
    EXPECT_EQ(soup.points[1], Point(1, 0, 0));
    EXPECT_EQ(soup.point_line, (std::vector<std::size_t>{11, 13, 15}));
    EXPECT_NE(
        failure(replaced(good, "1 0 0\n", "1 0 0 5\n")).find("a.ply:12: `5` is one value too many: vertex 1"),
        std::string::npos);
    EXPECT_NE(failure(replaced(good, "1 0 0\n", "1 O 0\n")).find("a.ply:12: `O` is not a number"),
              std::string::npos);
    EXPECT_NE(
        failure(replaced(good, "3 0 1 2", "3 0 1 1.5")).find("a.ply:14: `1.5` is no number of the type int"),
        std::string::npos);
}

template <class Number>
void append(std::string& bytes, Number number, bool big_endian) {
    std::array<char, sizeof(Number)> raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (big_endian) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.begin(), raw.end());
}

/// Binary PLY file with a colour for each vertex, doubles, short indices and an unknown element.
std::string binary(bool big_endian, double bad = 1) {
    std::string bytes =
        "ply\r\nformat binary_" + std::string(big_endian ? "big" : "little") +
        "_endian 1.0\r\nelement odd 2\r\nproperty list ushort int8 z\r\nelement vertex 3\r\n"
        "property uchar red\r\nproperty double x\r\nproperty float64 y\r\nproperty float z\r\n"
        "element face 1\r\nproperty list uint8 short vertex_index\r\nend_header\r\n";
    for (const std::uint16_t size : {0, 3}) {
        append(bytes, size, big_endian);
        bytes.append(size, '\7');
    }
    for (int v = 0; v < 3; ++v) {
        bytes += '\xaa';
        append(bytes, v == 1 ? bad : 0.0, big_endian);
        append(bytes, v == 2 ? 0.125 : 0.0, big_endian);
        append(bytes, -2.5f, big_endian);
    }
    bytes += '\3';
    for (const std::int16_t corner : {2, 0, 1}) append(bytes, corner, big_endian);
    return bytes;
}

TEST(Ply, BothOrdersOfBytesAndAllTypesAreRead) {
    for (const bool big_endian : {false, true}) {
        const PolygonSoup soup = parse(binary(big_endian));
        EXPECT_EQ(soup.points, (std::vector<Point>{{0, 0, -2.5}, {1, 0, -2.5}, {0, 0.125, -2.5}}));
        EXPECT_EQ(soup.polygons, (std::vector<std::vector<std::size_t>>{{2, 0, 1}}));
        EXPECT_TRUE(soup.point_line.empty());
        for (std::size_t size = 0; size < binary(big_endian).size(); ++size)
            EXPECT_NE(failure(binary(big_endian).substr(0, size)), "no error") << size;
    }
}

TEST(Ply, NumbersThatAreNoneAreNamedByTheirVertex) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
        for (const bool big_endian : {false, true})
            EXPECT_EQ(failure(binary(big_endian, bad)), "a.ply: vertex 1: a coordinate is NaN or infinite");
    EXPECT_EQ(failure(replaced(good, "1 0 0", "1 nan 0")),
              "a.ply:12: vertex 1: a coordinate is NaN or infinite");
}

// Properties must belong to the vertices in the order of the file, whatever their type; a message about an
// unknown name must list the known names.
TEST(Ply, PropertiesOfVerticesAreReadByName) {
    const std::string with =
        replaced(replaced(good, "property float z\n",
                          "property float z\nproperty list uchar int n\nproperty uchar q\n"),
                 "0 0 0\n1 0 0\n0 1 0\n", "0 0 0 0 7\n1 0 0 2 5 5 8\n0 1 0 1 5 9\n");
    EXPECT_EQ(parse_ply_property("a.ply", with, "q"), (std::vector<double>{7, 8, 9}));
    EXPECT_EQ(parse_ply_property("a.ply", with, "x"), (std::vector<double>{0, 1, 0}));
    for (const char* name : {"thick", "n"})
        EXPECT_NE(message_thrown_by([&] { parse_ply_property("a.ply", with, name); })
                      .find("a.ply:4: element vertex of the PLY file has no number `" + std::string(name) +
                            "`; it has x, y, z, q"),
                  std::string::npos);
    const TemporaryDirectory directory;
    EXPECT_EQ(read_vertex_property(directory.write("a.ply", with), "q").back(), 9);
    EXPECT_NE(message_thrown_by([&] { read_vertex_property("a.obj", "q"); }).find("a.obj: only a PLY file"),
              std::string::npos);
}

// Scans of the nineties, such as Stanford's, have strips instead of faces.
TEST(Ply, StripsOfTrianglesAreReadWhereThereAreNoFaces) {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    const std::string header = "ply\nformat ascii 1.0\n" + replaced(points_of_header, "3", "6") +
                               "element tristrips 1\nproperty list int int vertex_indices\n";
    const PolygonSoup strips = parse(header + "end_header\n" + points + "10 0 1 2 3 -1 2 3 3 4 5\n");
    // A repeated vertex makes two triangles of zero area, which are omitted.
    EXPECT_EQ(strips.polygons, (std::vector<std::vector<std::size_t>>{{0, 1, 2}, {2, 1, 3}, {3, 4, 5}}));
    EXPECT_TRUE(strips.warnings.empty());
    const PolygonSoup both =
        parse(header + faces_of_header + "end_header\n" + points + "4 0 1 2 3\n3 0 1 2\n");
    EXPECT_EQ(both.polygons.size(), 1U) << "strips beside faces are the faces once more";
    EXPECT_EQ(both.warnings, (std::vector<std::string>{"1 row of element `tristrips` was skipped (line 7)"}));
    EXPECT_EQ(failure(header + "end_header\n" + points + "3 0 1 9\n"),
              "a.ply:16: face 0: index out of range: there is no vertex 9, the file has 6 (numbered from 0)");
}

// Programs write colours in any type of number, often with values from 0 to 255: the largest value must tell
// the scale.
TEST(Ply, TheLargestColourTellsWhatFullLightIs) {
    const auto content_of = [](const std::string& type, const std::string& colours) {
        std::string content = good;
        for (const char* name : {"blue", "green", "red"})
            content = replaced(content, "property float z\n",
                               "property float z\nproperty " + type + " " + name + "\n");
        return replaced(content, "0 0 0\n1 0 0\n0 1 0\n",
                        "0 0 0 " + colours + "\n1 0 0 0 0 0\n0 1 0 0 0 0\n");
    };
    const auto first_colour = [&](const std::string& type, const std::string& colours) {
        return parse(content_of(type, colours)).look.vertex_colour[0];
    };
    const Colour expected{200, 30, 10, 255};
    for (const char* type : {"uchar", "short", "int", "uint", "float", "double"})
        EXPECT_EQ(first_colour(type, "200 30 10"), expected) << type;
    EXPECT_EQ(first_colour("ushort", "65535 257 0"), (Colour{255, 1, 0, 255}));
    EXPECT_EQ(first_colour("float", "1 0.2 0"), (Colour{255, 51, 0, 255}));
    EXPECT_EQ(first_colour("float", "1.5 0.2 nan"), (Colour{255, 51, 0, 255})) << "brighter than white";
    // Without this rule a map with values from 0 to 255 would be 1 everywhere.
    for (const char* type : {"uchar", "float"})
        EXPECT_EQ(parse_ply_property("a.ply", content_of(type, "204 51 0"), "red")[0], 0.8) << type;
    EXPECT_EQ(parse_ply_property("a.ply", content_of("float", "0.75 0 0"), "red")[0], 0.75);
}

// If colours were not read or not written, a painted scan would lose them in a run.
TEST(Ply, ColoursOfVerticesAndFacesAreReadAndWrittenAgain) {
    std::string content = replaced(good, "property float z\n",
                                   "property float z\nproperty uchar red\nproperty uchar green\n"
                                   "property uchar blue\nproperty uchar alpha\n");
    content = replaced(content, "vertex_indices\n",
                       "vertex_indices\nproperty float diffuse_red\nproperty float diffuse_green\n"
                       "property float diffuse_blue\n");
    content = replaced(content, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                       "0 0 0 1 2 3 4\n1 0 0 250 251 252 255\n0 1 0 0 0 0 0\n3 0 1 2 0 0.5 7\n");
    const TemporaryDirectory folder;
    folder.write("a.ply", content);
    std::vector<std::string> warnings;
    const Mesh mesh = read_mesh(folder.path / "a.ply", {}, warnings);
    write_mesh(triangle_sheet(mesh), folder.path / "b.ply");
    for (const Mesh& known : {mesh, read_mesh(folder.path / "b.ply", {}, warnings)}) {
        const auto [vertex, has_vertex] = find_property(known, attribute::vertex_colour);
        const auto [face, has_face] = find_property(known, attribute::face_colour);
        ASSERT_TRUE(has_vertex && has_face);
        EXPECT_EQ(vertex[Vertex(0)], (Colour{1, 2, 3, 4}));
        EXPECT_EQ(vertex[Vertex(1)], (Colour{250, 251, 252, 255}));
        EXPECT_EQ(vertex[Vertex(2)], (Colour{0, 0, 0, 0}));
        EXPECT_EQ(face[Face(0)], (Colour{0, 128, 255, 255})) << "a part out of range is cut off";
    }
}

// A single component of a colour, without the other two, belongs to something else, such as a measured
// value.
TEST(Ply, APartOfAColourIsNone) {
    EXPECT_TRUE(parse(replaced(replaced(good, "property float z\n", "property float z\nproperty uchar red\n"),
                               "0 0 0\n1 0 0\n0 1 0\n", "0 0 0 1\n1 0 0 1\n0 1 0 1\n"))
                    .look.vertex_colour.empty());
}

}  // namespace
}  // namespace sherd::test
