// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>

#include "meshops/error.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_write/text_line.h"
#include "meshops/soup/polygon_soup.h"

// CGAL's reader is not used: it takes NaN for a point that it has seen before, and a short text that it does
// not understand for an empty binary file.
namespace sherd {
namespace {

constexpr std::size_t stl_header = 84, stl_record = 50;  // bytes of the header, and of a triangle

/// Returns the number of triangles that the header of a binary file states; 0 if the file is shorter than
/// that.
std::uint32_t promised_triangles(std::string_view bytes) {
    return bytes.size() < stl_header ? 0 : number_at<std::uint32_t>(bytes.data() + 80, std::endian::little);
}

bool fits_binary(std::string_view bytes) {
    return bytes.size() >= stl_header && bytes.size() - stl_header == stl_record * promised_triangles(bytes);
}

/// Returns the number of triangles in a binary file, with a warning if it is not the number in the header.
/// Some programs leave 0 or the largest number in the header, and some state fewer than they write: then the
/// size of the file gives the number.
std::size_t count_triangles(PolygonSoup& soup, std::string_view bytes) {
    constexpr std::uint32_t unknown = -1;
    const std::size_t promised = promised_triangles(bytes);
    const std::size_t room = bytes.size() < stl_header ? 0 : (bytes.size() - stl_header) / stl_record;
    const bool is_unknown = promised == unknown || promised == 0;
    if (bytes.size() < stl_header || (promised > room && !is_unknown)) {
        throw Error(soup.file.string() + ": the binary STL file ends too early (truncated?): it has " +
                    std::to_string(bytes.size()) + " bytes, its " + std::to_string(promised) +
                    " triangles take " + std::to_string(stl_header + stl_record * promised));
    }
    const std::size_t beyond = bytes.size() - stl_header - stl_record * room;
    const std::size_t count = is_unknown || beyond == 0 ? room : promised;
    if (count != promised)
        soup.warnings.push_back("the header of the binary STL file says that it has " +
                                std::to_string(promised) + " triangles, but the file holds " +
                                std::to_string(count) + ", which are read");
    else if (bytes.size() > stl_header + stl_record * count)
        soup.warnings.push_back(std::to_string(bytes.size() - stl_header - stl_record * count) +
                                " bytes after the last triangle were skipped");
    return count;
}

/// Parses a binary file. It has a header of 80 bytes and the number of triangles, then for each triangle 12
/// floats (normal, corners) and 2 bytes.
PolygonSoup parse_binary_stl(const std::filesystem::path& file, std::string_view text) {
    PolygonSoup soup;
    soup.file = file;
    const std::size_t count = count_triangles(soup, text);
    for (std::size_t i = 0; i < count; ++i) {
        soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const char* bytes = text.data() + stl_header + stl_record * i + 12 * (corner + 1);
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

/// Parses a text, word by word: `vertex x y z` comes three times between `facet` and `endfacet`, and
/// `endsolid` follows the last facet. Line ends matter only behind `solid`, since they end the name that
/// stands there.
class StlText {
  public:
    StlText(const std::filesystem::path& file, std::string_view text) : words(file, text) {
        soup.file = file;
    }

    PolygonSoup parse() {
        while (!words.is_at_end()) read(lower_case(words.next()));
        if (is_complete) return std::move(soup);
        if (has_begun)
            throw Error(soup.file.string() +
                        ": the STL file ends too early (truncated?): `endsolid` is missing");
        throw Error(soup.file.string() +
                    ": is no STL file: it has neither the words `solid` and `facet normal` of a text file "
                    "nor the size of a binary one");
    }

  private:
    void read(const std::string& keyword) {
        if (keyword == "solid") begin_solid();
        if (keyword == "endsolid") end_solid();
        if (keyword == "facet") begin_facet();
        if (keyword == "vertex" && is_in_facet) add_vertex();
        if (keyword == "endfacet" && is_in_facet) end_facet();
    }

    void begin_solid() {
        has_begun = is_in_solid = true;
        skip_name();
    }
    void end_solid() {
        is_complete = is_complete || is_in_solid;
        is_in_solid = is_in_facet = false;
    }

    /// Skips the name of a solid, which ends with its line or where the first facet begins.
    void skip_name() {
        TextLine& line = words.rest_of_line();
        while (!line.is_at_end() && !begins_facet(line)) line.next_word();
    }
    static bool begins_facet(TextLine line) {
        return lower_case(line.next_word()) == "facet" && lower_case(line.next_word()) == "normal";
    }

    /// Begins a facet. Any text may stand outside of solids, so that there a `facet` counts only if `normal`
    /// follows it.
    void begin_facet() {
        TextLine ahead = words.rest_of_line();
        if (!is_in_solid && lower_case(ahead.next_word()) != "normal") return;
        has_begun = is_in_solid = is_in_facet = true;
        is_complete = false;
    }

    void add_vertex() {
        const std::size_t line = words.number();
        const double x = words.next_number(), y = words.next_number(), z = words.next_number();
        soup.points.emplace_back(x, y, z);
        soup.point_line.push_back(line);
    }

    void end_facet() {
        const std::size_t first = 3 * soup.polygons.size();
        if (soup.points.size() != first + 3)
            words.rest_of_line().fail("a facet of STL needs three vertices", {});
        soup.polygons.push_back({first, first + 1, first + 2});
        soup.polygon_line.push_back(words.number());
        is_in_facet = false;
    }

    TextWords words;
    PolygonSoup soup;
    bool has_begun = false, is_in_solid = false, is_in_facet = false;
    bool is_complete = false;  ///< whether `endsolid` follows the last facet
};

/// Returns the text without the zero bytes with which some programs pad its end.
std::string_view without_padding(std::string_view text) {
    return text.substr(0, text.find_last_not_of('\0') + 1);
}

/// Parses a file, which is binary or a text according to its size and content: `solid` is at the beginning of
/// some binary files, too, and not of all texts.
PolygonSoup read_stl(const std::filesystem::path& file, std::string_view content) {
    if (fits_binary(content)) return parse_binary_stl(file, content);
    const std::string_view text = without_padding(without_byte_order_mark(file, content));
    return is_binary(text) ? parse_binary_stl(file, content) : StlText(file, text).parse();
}

}  // namespace

PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text) {
    PolygonSoup soup = read_stl(file, text);
    // The check comes before joining, which compares coordinates and so requires that none is NaN.
    check_polygon_soup(soup);
    join_duplicate_points(soup);
    drop_unused_points(soup);
    return soup;
}

}  // namespace sherd
