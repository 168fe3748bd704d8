// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>

#include "meshops/error.h"
#include "meshops/polygon_soup.h"
#include "meshops/raw_bytes.h"
#include "meshops/text_line.h"

// CGAL's reader is not used: it takes NaN for a point that it has seen before, and a short text that it does
// not understand for an empty binary file.
namespace sherd {
namespace {

/// A binary file has a header of 80 bytes and the number of triangles, then for each triangle 12 floats
/// (normal, corners) and 2 bytes.
PolygonSoup parse_binary_stl(const std::filesystem::path& file, std::string_view text) {
    constexpr std::size_t header = 84, record = 50;
    const std::size_t count =
        text.size() < header ? 0 : number_at<std::uint32_t>(text.data() + 80, std::endian::little);
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
                const float value = number_at<float>(bytes + 4 * k, std::endian::little);
                // The format has no numbered vertices, so the message names the face and its corner.
                if (!std::isfinite(value))
                    throw Error(file.string() + ": face " + std::to_string(i) + ": coordinate " + "xyz"[k] +
                                " of its corner " + std::to_string(corner) + " is NaN or infinite");
                return value;
            };
            const double x = coordinate(0), y = coordinate(1), z = coordinate(2);
            soup.points.emplace_back(x, y, z);
        }
    }
    return soup;
}

/// Removes the points that no polygon uses; the others keep their order.
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

/// A text has lines `vertex x y z`, three between each `facet` and `endfacet`, and ends with `endsolid`.
PolygonSoup parse_text_stl(const std::filesystem::path& file, std::string_view text) {
    PolygonSoup soup;
    soup.file = file;
    bool is_complete = false;
    TextLines lines(file, text);
    while (auto line = lines.next_with_words()) {
        const std::string keyword = lower_case(line->next_word());
        if (keyword == "vertex") {
            const double x = line->next_number(), y = line->next_number(), z = line->next_number();
            soup.points.emplace_back(x, y, z);
            soup.point_line.push_back(lines.number());
        } else if (keyword == "endfacet") {
            const std::size_t first = 3 * soup.polygons.size();
            if (soup.points.size() != first + 3) line->fail("a facet of STL needs three vertices", {});
            soup.polygons.push_back({first, first + 1, first + 2});
            soup.polygon_line.push_back(lines.number());
        }
        is_complete = keyword == "endsolid";
    }
    if (is_complete) return soup;
    throw Error(file.string() + ": the STL file ends too early (truncated?): `endsolid` is missing");
}

}  // namespace

PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text) {
    if (!is_binary(text)) text = without_byte_order_mark(file, text);
    const bool is_text = lower_case(text.substr(0, 5)) == "solid" && !is_binary(text);
    PolygonSoup soup = is_text ? parse_text_stl(file, text) : parse_binary_stl(file, text);
    // The check comes before joining, which compares coordinates and so requires that they are numbers.
    check_polygon_soup(soup);
    join_duplicate_points(soup);
    drop_unused_points(soup);
    return soup;
}

}  // namespace sherd
