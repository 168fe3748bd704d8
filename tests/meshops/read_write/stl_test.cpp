// SPDX-License-Identifier: GPL-3.0-or-later
// STL files as programs write them: the format follows from the content.
#include <gtest/gtest.h>

#include <bit>

#include "tests/support/mesh/mesh_reading.h"

namespace sherd {
namespace {

using ReadStl = test::MeshReading;
using test::triangles;

const test::Triangles square_faces{{0, 1, 2}, {0, 2, 3}};

std::string facet_of(const std::string& corners) {
    return "facet normal 0 0 1\nouter loop\n" + corners + "endloop\nendfacet\n";
}
const std::string two_facets = facet_of("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n") +
                               facet_of("vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n");
const std::string whole_stl = "solid a\n" + two_facets + "endsolid a\n";

/// Binary STL file with the two faces of a square, whose header has `count` as the number of faces.
std::string stl_of(std::uint32_t count, const std::string& header = "solid") {
    std::string result = header + std::string(80 - header.size(), ' ');
    const auto append = [&](std::uint32_t word) {
        for (int i = 0; i < 4; ++i) result += static_cast<char>(word >> 8 * i & 255);
    };
    append(count);
    for (const auto& corners :
         {std::array{0, 0, 0, 1, 0, 0, 1, 1, 0}, std::array{0, 0, 0, 1, 1, 0, 0, 1, 0}}) {
        for (int k = 0; k < 3; ++k) append(0);
        for (const int value : corners) append(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        result += std::string(2, '\0');
    }
    return result;
}

std::string on_one_line(std::string lines) {
    std::ranges::replace(lines, '\n', ' ');
    return lines;
}

std::string in_capitals(std::string words) {
    std::ranges::transform(words, words.begin(), [](unsigned char c) { return std::toupper(c); });
    return words;
}

// Programs differ in line breaks, capitals and the words around facets. A reader that expected certain
// lines, or that took a file for a text only if it begins with "solid", would lose the file or half of it.
TEST_F(ReadStl, ReadsTextsHoweverTheyAreSetOut) {
    for (const std::string& set_out :
         {whole_stl, "\xEF\xBB\xBF" + whole_stl, in_capitals(whole_stl),
          "Solid\n" + two_facets + "EndSolid\n", "\n \t" + whole_stl, "; by a mill, a solid\n" + whole_stl,
          whole_stl + "a solid of 2 facets\n", on_one_line(whole_stl),
          on_one_line("solid the facet\n" + two_facets + "endsolid\n"), two_facets + "endsolid\n",
          whole_stl.substr(0, whole_stl.find("vertex 1 0 0")) + "vertex\n1\n0 0\n" +
              whole_stl.substr(whole_stl.find("vertex 1 0 0") + 13),
          whole_stl + std::string(3, '\0'), "solid a\nendsolid\n" + whole_stl}) {
        EXPECT_EQ(triangles(read("a.stl", set_out)), square_faces) << set_out;
        EXPECT_TRUE(warnings.empty()) << set_out;
    }
    const std::string two = "solid a\n" + facet_of("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n") +
                            "endsolid a\nsolid b\n" + facet_of("vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n");
    EXPECT_EQ(triangles(read("two.stl", two + "endsolid b\n")), square_faces);
    EXPECT_EQ(triangles(read("two.stl", on_one_line(two + "endsolid b\n"))), square_faces);
    expect_failure("two.stl", two, "truncated");
}

// Streaming exporters leave the initial count, and other exporters count wrongly: with the count of the
// header a part of the sheet would be missing without a message.
TEST_F(ReadStl, TakesTheTrianglesThatAreThere) {
    EXPECT_EQ(triangles(read("a.stl", stl_of(2))), square_faces);
    EXPECT_TRUE(warnings.empty());
    for (const std::uint32_t count : {0U, 1U, 0xffffffffU}) {
        EXPECT_EQ(triangles(read("a.stl", stl_of(count))), square_faces);
        expect_warning("says that it has " + std::to_string(count) + " triangles, but the file holds 2");
    }
    EXPECT_EQ(triangles(read("a.stl", stl_of(2) + "made by a mill")), square_faces);
    expect_warning("14 bytes after the last triangle were skipped");
    EXPECT_EQ(triangles(read("a.stl", stl_of(2, "\xEF\xBB\xBF"))), square_faces);
    expect_failure("a.stl", stl_of(3), "truncated");
}

TEST_F(ReadStl, SaysWhatIsNoStl) {
    expect_failure("a.stl", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "is no STL file");
    expect_failure("a.stl", std::string("\xFF\xFEs\0o\0", 6), "UTF-16");
    expect_failure("a.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 0\nendfacet\nendsolid\n",
                   "a.stl:4: a facet");
}

}  // namespace
}  // namespace sherd
