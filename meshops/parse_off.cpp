// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "meshops/error.h"
#include "meshops/polygon_soup.h"
#include "meshops/raw_bytes.h"
#include "meshops/text_line.h"

// CGAL's reader is not used: it searches colours and texture coordinates beyond the end of a line that has
// fewer numbers than the header's keyword announces, and allocates as much memory as a face's number of
// corners says.
namespace sherd {
namespace {

constexpr char comment = '#';

/// The header: `[ST][C][N][4][n]OFF [BINARY]`, then the numbers of vertices, faces and edges.
struct OffHeader {
    std::size_t coordinates = 3;  ///< number of coordinates of a vertex; 4: homogeneous
    std::size_t extras = 0;       ///< number of further values of a vertex in a binary file
    bool has_dimension = false;   ///< whether a dimension precedes the numbers of vertices and faces
    bool is_binary = false;
    std::size_t vertices = 0, faces = 0;
};

[[noreturn]] void fail_at_end(const std::filesystem::path& file, const std::string& where) {
    throw Error(file.string() + ": the OFF file ends too early (truncated?): " + where);
}

OffHeader read_keyword(TextLine& line) {
    const std::string_view word = line.next_word();
    std::string_view rest = word;
    const auto take = [&](std::string_view part) {
        const bool has = rest.starts_with(part);
        if (has) rest.remove_prefix(part.size());
        return has;
    };
    OffHeader header;
    const bool texture = take("ST"), colour = take("C"), normal = take("N");
    if (take("4")) header.coordinates = 4;
    header.has_dimension = take("n");
    if (rest != "OFF") line.fail("cannot be understood as OFF: write `OFF` in front", word.substr(0, 40));
    header.extras = (texture ? 2 : 0) + (colour ? 4 : 0) + (normal ? 3 : 0);
    TextLine ahead = line;
    header.is_binary = ahead.next_word() == "BINARY";
    return header;
}

void require_room(const std::filesystem::path& file, const OffHeader& header, std::size_t available) {
    const std::size_t vertex =
        header.is_binary ? 4 * (header.coordinates + header.extras) : 2 * header.coordinates;
    const std::size_t face = header.is_binary ? 8 : 2, room = available + 1;  // the last line may have no end
    if (header.vertices <= room / vertex && header.faces <= (room - vertex * header.vertices) / face) return;
    fail_at_end(file, "its header promises " + std::to_string(header.vertices) + " vertices and " +
                          std::to_string(header.faces) + " faces, and " + std::to_string(available) +
                          " bytes follow it");
}

void require_dimension(const std::filesystem::path& file, const OffHeader& header, std::size_t dimension) {
    if (header.has_dimension && dimension != 3)
        throw Error(file.string() + ": the OFF file has " + std::to_string(dimension) +
                    " coordinates for each vertex; a sheet needs 3");
}

/// The words of a text, regardless of lines.
class OffText {
  public:
    OffText(const std::filesystem::path& file, std::string_view text) : file(file), lines(file, text) {}

    PolygonSoup parse() {
        soup.file = file;
        next_line("it has no header");
        OffHeader header = read_keyword(*line);
        if (header.has_dimension) require_dimension(file, header, next_count());
        header.vertices = next_count();
        header.faces = next_count();
        next_count();  // the number of edges is not used
        require_room(file, header, lines.remaining().size());
        for (std::size_t i = 0; i < header.vertices; ++i) read_vertex(header, i);
        for (std::size_t i = 0; i < header.faces; ++i) read_face(i);
        return std::move(soup);
    }

  private:
    void next_line(const std::string& where) {
        line = lines.next_with_words(comment);
        if (!line) fail_at_end(file, where);
    }

    /// Reads a nonnegative integer.
    std::size_t next_integer(const char* what) {
        const TextLine before = *line;
        const double value = line->next_number();
        if (value >= 0 && value < 1e15 && value == static_cast<double>(static_cast<std::int64_t>(value)))
            return static_cast<std::size_t>(value);
        TextLine again = before;
        again.fail(what, again.next_word());
    }
    std::size_t next_count() {
        if (line->is_at_end()) next_line("its header does not say how many vertices and faces there are");
        return next_integer("cannot be understood as a number of vertices or faces of OFF");
    }

    void read_vertex(const OffHeader& header, std::size_t number) {
        next_line("vertex " + std::to_string(number) + " of " + std::to_string(header.vertices) +
                  " is missing");
        const double x = line->next_number(), y = line->next_number(), z = line->next_number();
        const double weight = header.coordinates == 4 ? line->next_number() : 1;
        soup.points.emplace_back(x / weight, y / weight, z / weight);
        soup.point_line.push_back(lines.number());
    }

    void read_face(std::size_t number) {
        next_line("face " + std::to_string(number) + " is missing");
        TextLine before = *line;
        const std::size_t count =
            next_integer("cannot be understood as a number of corners of a face of OFF");
        std::vector<std::size_t>& polygon = soup.polygons.emplace_back();
        for (std::size_t corner = 0; corner < count; ++corner) {
            if (line->is_at_end())
                before.fail("corners were promised, the line has fewer", before.next_word());
            polygon.push_back(next_integer("is no vertex number"));
        }
        soup.polygon_line.push_back(lines.number());
    }

    const std::filesystem::path& file;
    TextLines lines;
    std::optional<TextLine> line;
    PolygonSoup soup;
};

/// Big-endian integers and floats after the header line.
class OffBytes {
  public:
    OffBytes(const std::filesystem::path& file, OffHeader header, std::string_view bytes)
        : file(file), header(header), bytes(bytes) {}

    PolygonSoup parse() {
        PolygonSoup soup;
        soup.file = file;
        if (header.has_dimension) require_dimension(file, header, next<std::uint32_t>());
        header.vertices = next<std::uint32_t>();
        header.faces = next<std::uint32_t>();
        next<std::uint32_t>();  // the number of edges is not used
        require_room(file, header, bytes.size());
        for (std::size_t i = 0; i < header.vertices; ++i) {
            const double x = next<float>(), y = next<float>(), z = next<float>();
            const double weight = header.coordinates == 4 ? next<float>() : 1;
            soup.points.emplace_back(x / weight, y / weight, z / weight);
            for (std::size_t k = 0; k < header.extras; ++k) next<float>();
        }
        for (std::size_t i = 0; i < header.faces; ++i) {
            std::vector<std::size_t>& polygon = soup.polygons.emplace_back();
            for (auto left = next<std::uint32_t>(); left > 0; --left)
                polygon.push_back(static_cast<std::size_t>(std::int64_t{next<std::int32_t>()}));
            for (auto left = next<std::uint32_t>(); left > 0; --left) next<float>();  // skips the colour
        }
        return soup;
    }

  private:
    template <class Number>
    Number next() {
        if (bytes.size() < sizeof(Number)) fail_at_end(file, "a number is missing at its end");
        const Number number = number_at<Number>(bytes.data(), std::endian::big);
        bytes.remove_prefix(sizeof(Number));
        return number;
    }

    const std::filesystem::path& file;
    OffHeader header;
    std::string_view bytes;
};

}  // namespace

PolygonSoup parse_off(const std::filesystem::path& file, std::string_view content) {
    TextLines lines(file, content);
    std::optional<TextLine> line = lines.next_with_words(comment);
    if (!line) throw Error(file.string() + ": the OFF file is empty");
    const OffHeader header = read_keyword(*line);
    return header.is_binary ? OffBytes(file, header, lines.remaining()).parse()
                            : OffText(file, content).parse();
}

}  // namespace sherd
