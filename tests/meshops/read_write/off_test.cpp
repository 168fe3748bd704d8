// SPDX-License-Identifier: GPL-3.0-or-later
// OFF files as programs write them, with more numbers in a line than a mesh needs, and damaged ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "meshops/error.h"
#include "meshops/soup/polygon_soup.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

std::string off_failure(const std::string& content) {
    return message_thrown_by([&] { check_polygon_soup(parse_off("a.off", content)); });
}

const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
using Polygons = std::vector<std::vector<std::size_t>>;

TEST(Off, WhatStandsBehindPointsAndCornersIsPassedOver) {
    for (const std::string text :
         {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
          ("# by hand\nCOFF # with colours\n\n3 1 3 # counts\n0 0 0 255 0 0 255\n# a point\n1 0 0\n0 1 0 1 1 "
           "1\n"
           "3 0 1 2 0.5 0.5 0.5 1\n"),
          "STNOFF\n3\n1\n0\n0 0 0 0 0 1 0.5 0.5\n1 0 0\n0 1 0\n3 0 1 2 7\n",
          "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n",
          "nOFF 3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}) {
        const PolygonSoup soup = parse_off("a.off", text);
        EXPECT_EQ(soup.points, corners) << text;
        EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2}})) << text;
    }
}

// Programs and data sets differ in their headers, and the format ignores line breaks.
TEST(Off, HeadersAndLinesAreAsProgramsWriteThem) {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n", face = "3 0 1 2\n";
    for (const std::string& text :
         {"OFF3 1 0\n" + points + face, "COFF3 1 0\n" + points + face, "NCOFF\n3 1 0\n" + points + face,
          "CNSTOFF\n3 1 0\n" + points + face, "off\n3 1 0\n" + points + face, "3 1 0\n" + points + face,
          "OFF\n3 1\n" + points + face, "OFF 3 1\n" + points + face,
          "\n# comment\nOFF # of a ring\n3 # vertices\n1\n\n0 # edges\n" + points + face,
          "n4OFF\n3\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n" + face,
          std::string("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"),
          std::string("OFF\n3 1 0\n0 0 0 1 0\n0 0 1 0\n3 0\n1 2\n"),
          std::string("OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2 255 0 0\n"),
          std::string("NOFF\n3 1 0\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n"),
          std::string("OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r")}) {
        const PolygonSoup soup = parse_off("a.off", text);
        EXPECT_EQ(soup.points, corners) << text;
        EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2}})) << text;
    }
}

template <class Number>
void append(std::string& bytes, Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    std::reverse(raw.begin(), raw.end());
    bytes.append(raw.begin(), raw.end());
}

TEST(Off, BinaryFilesAreReadAndNotBelieved) {
    std::string bytes = "COFF BINARY\n";
    for (const std::int32_t count : {3, 1, 0}) append(bytes, count);
    for (const Point& p : corners)
        for (const double value : {p.x(), p.y(), p.z(), 1.0, 0.5, 0.0, 1.0})
            append(bytes, static_cast<float>(value));
    for (const std::int32_t number : {3, 0, 1, 2, 1}) append(bytes, number);
    append(bytes, 0.5f);
    const PolygonSoup soup = parse_off("a.off", bytes);
    EXPECT_EQ(soup.points, corners);
    EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2}}));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(off_failure(bytes.substr(0, size)), "no error") << size;
    for (const std::size_t at : {12, 16, 108}) {  // places of the numbers of vertices, faces and corners
        std::string many = bytes;
        many.replace(at, 4, "\x7f\xff\xff\xff");
        EXPECT_NE(off_failure(many).find("truncated"), std::string::npos) << at << off_failure(many);
    }
}

TEST(Off, MistakesAreNamedWithTheirLine) {
    const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    const auto expect = [](const std::string& text, const std::string& message) {
        EXPECT_NE(off_failure(text).find(message), std::string::npos) << off_failure(text) << "\nof " << text;
    };
    expect(head + "300000000 0 1 2\n", "a.off:6: `300000000` corners were announced, but the line has fewer");
    expect(head + "3 0 1 x\n", "a.off:6: `x` is not a number");
    expect(head + "3 0 1 -1\n", "a.off:6: `-1` is no vertex number");
    expect(head + "3 0 1 3\n", "a.off:6: face 0: index out of range");
    expect("OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off:3: a coordinate is missing");
    expect("OFF\n2000000000 1 0\n0 0 0\n", "promises 2000000000 vertices and 1 faces, and 6 bytes follow it");
    expect("OFF\nthree 1 0\n", "a.off:2: `three` is not a number");
    expect("OFF\n1.5 1 0\n", "a.off:2: `1.5` is not a number of vertices");
    expect("SKEL\n3 1 0\n", "a.off:1: `SKEL` is not the start of an OFF file");
    expect("nOFF 4\n3 1 0\n", "4 coordinates for each vertex");
    expect("4OFF\n3 1 0\n0 0 0 0\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", "a.off:3: vertex 0: a coordinate is NaN");
}

}  // namespace
}  // namespace sherd::test
