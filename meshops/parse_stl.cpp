// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstdint>

#include "meshops/error.h"
#include "meshops/polygon_soup.h"
#include "meshops/text_line.h"

// Read here and not by CGAL, whose reader takes a NaN for a point it has seen before, and a short text it
// does not understand for an empty binary file.
namespace sherd {
namespace {

std::uint32_t little_endian_word(const char* bytes) {
    std::uint32_t word = 0;
    for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
    return word;
}

/// Header of 80 bytes, number of triangles, then for each 12 floats (normal, corners) and 2 bytes.
PolygonSoup parse_binary_stl(const std::filesystem::path& file, std::string_view text) {
    constexpr std::size_t header = 84, record = 50;
    const std::size_t count = text.size() < header ? 0 : little_endian_word(text.data() + 80);
    if (text.size() < header + record * count) {
        throw Error(file.string() + ": the binary STL file ends too early (truncated?): it has " +
                    std::to_string(text.size()) + " bytes, its " + std::to_string(count) +
                    " triangles take " + std::to_string(header + record * count));
    }
    PolygonSoup soup;
    soup.file = file;
    for (std::size_t i = 0; i < count; ++i) {
        soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const char* bytes = text.data() + header + record * i + 12 * (corner + 1);
            const auto coordinate = [&](int k) {
                return std::bit_cast<float>(little_endian_word(bytes + 4 * k));
            };
            soup.points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        }
    }
    return soup;
}

/// Keeps of the points those in use, in order.
void drop_unused_points(PolygonSoup& soup) {
    std::vector<std::size_t> number(soup.points.size(), 0);
    for (const auto& polygon : soup.polygons) {
        for (const std::size_t corner : polygon) number[corner] = 1;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == 0) continue;
        soup.points[count] = soup.points[i];
        if (!soup.point_line.empty()) soup.point_line[count] = soup.point_line[i];
        number[i] = count++;
    }
    soup.points.resize(count);
    for (auto& polygon : soup.polygons) {
        for (auto& corner : polygon) corner = number[corner];
    }
}

/// Lines `vertex x y z`, three between each `facet` and `endfacet`; `endsolid` at the end.
PolygonSoup parse_text_stl(const std::filesystem::path& file, std::string_view text) {
    PolygonSoup soup;
    soup.file = file;
    bool is_complete = false;
    for (std::size_t number = 1; !text.empty(); ++number) {
        TextLine line(file, number, text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
        const std::string_view keyword = line.next_word();
        if (keyword == "vertex") {
            const double x = line.next_number(), y = line.next_number(), z = line.next_number();
            soup.points.emplace_back(x, y, z);
            soup.point_line.push_back(number);
        } else if (keyword == "endfacet") {
            const std::size_t first = 3 * soup.polygons.size();
            if (soup.points.size() != first + 3) line.fail("a facet of STL needs three vertices", {});
            soup.polygons.push_back({first, first + 1, first + 2});
            soup.polygon_line.push_back(number);
        }
        if (!keyword.empty()) is_complete = keyword == "endsolid";
    }
    if (is_complete) return soup;
    throw Error(file.string() + ": the STL file ends too early (truncated?): `endsolid` is missing");
}

}  // namespace

PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text) {
    const bool is_text = text.starts_with("solid") && !is_binary(text);
    PolygonSoup soup = is_text ? parse_text_stl(file, text) : parse_binary_stl(file, text);
    // Before joining, which needs coordinates that compare.
    check_polygon_soup(soup);
    join_duplicate_points(soup);
    drop_unused_points(soup);
    return soup;
}

}  // namespace sherd
