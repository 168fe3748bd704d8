// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <optional>

#include "meshops/error.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_write/text_line.h"
#include "meshops/soup/polygon_soup.h"

// CGAL's reader is not used: it searches for colours and texture coordinates beyond the end of a line that
// has fewer numbers than the keyword of the header announces, and allocates memory for any number of corners
// that a face claims to have.
namespace sherd {
namespace {

constexpr char comment = '#';

/// The header: `[ST][C][N][4][n]OFF [BINARY]`, then the numbers of vertices, faces and edges.
struct OffHeader {
    std::size_t coordinates = 3;  ///< number of coordinates of a vertex; 4: homogeneous
    std::size_t extras = 0;  ///< number of further values of a vertex: normal, colour, texture coordinates
    bool has_dimension = false;  ///< whether a dimension precedes the numbers of vertices and faces
    bool is_binary = false;
    std::size_t vertices = 0, faces = 0;
};

[[noreturn]] void fail_at_end(const std::filesystem::path& file, const std::string& where) {
    throw Error(file.string() + ": the OFF file ends too early (truncated?): " + where);
}

/// Removes the letters in front of `OFF`, which may have any order, from the keyword `word`. Returns the
/// header that they describe.
OffHeader take_letters(std::string_view& word) {
    const auto take = [&](std::string_view part) {
        const bool has = word.starts_with(part);
        if (has) word.remove_prefix(part.size());
        return has;
    };
    OffHeader header;
    while (true) {
        if (take("ST") || take("st"))
            header.extras += 2;
        else if (take("C") || take("c"))
            header.extras += 4;
        else if (take("N"))
            header.extras += 3;
        else if (take("4"))
            header.coordinates = 4;
        else if (take("n"))
            header.has_dimension = true;
        else
            return header;
    }
}

bool has_digits_only(std::string_view word) {
    return word.find_first_not_of("0123456789") == word.npos;
}

/// Reads the keyword of the first line, and leaves the rest of the line. The keyword may be missing, and the
/// number of vertices may follow it without a blank.
OffHeader read_keyword(TextLine& line) {
    TextLine ahead = line;
    const std::string_view word = ahead.next_word();
    if (has_digits_only(word)) return {};
    std::string_view rest = word;
    OffHeader header = take_letters(rest);
    const std::string_view count = rest.substr(std::min<std::size_t>(rest.size(), 3));
    if (lower_case(rest.substr(0, 3)) != "off" || !has_digits_only(count))
        line.fail("is not the start of an OFF file: write `OFF` in front of it", word.substr(0, 40));
    line = ahead;
    header.is_binary = lower_case(ahead.next_word()) == "binary";
    line.put_back(count);
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

/// Layout of a text file.
enum class OffLayout {
    lines,  ///< a line for each vertex and each face; further words in it are ignored
    words,  ///< vertices and faces regardless of lines; a vertex has the colours, normals and so on that the
            ///< keyword names
    face_colours,  ///< vertices as in `words`; behind a face, the rest of its line is a colour
};

class OffText {
  public:
    OffText(const std::filesystem::path& file, std::string_view text, OffLayout layout)
        : file(file), lines(file, text), layout(layout) {}

    PolygonSoup parse() {
        soup.file = file;
        next_line("it has no header");
        header = read_keyword(*line);
        if (header.has_dimension) require_dimension(file, header, next_count());
        header.vertices = next_count();
        header.faces = next_count();
        skip_edge_count();
        require_room(file, header, line->length() + lines.remaining().size());
        for (std::size_t i = 0; i < header.vertices; ++i) read_vertex(i);
        for (std::size_t i = 0; i < header.faces; ++i) read_face(i);
        if (layout != OffLayout::lines && (!line->is_at_end() || lines.next_with_words(comment)))
            line->fail("does not belong to a vertex or a face", line->next_word());
        return std::move(soup);
    }

  private:
    void next_line(const std::string& where) {
        line = lines.next_with_words(comment);
        if (!line) fail_at_end(file, where);
    }
    /// Moves to where the next vertex or face may begin. where: what is missing, for the message at the end
    /// of the file.
    void next_element(const std::string& where) {
        if (layout == OffLayout::lines || line->is_at_end()) next_line(where);
    }
    void next_part() {
        if (layout != OffLayout::lines && line->is_at_end()) next_line("a number is missing");
    }
    double next_number() {
        next_part();
        return line->next_number();
    }

    /// Reads a nonnegative integer. Throws Error with the message `what` if the next word is none.
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
        return next_integer("is not a number of vertices or faces");
    }

    /// Skips the number of edges, which is not used. Some programs leave it out: then the next line is a
    /// vertex, which has more than one word.
    void skip_edge_count() {
        if (!line->is_at_end()) {
            next_count();
            return;
        }
        TextLines after = lines;
        std::optional<TextLine> next = after.next_with_words(comment);
        if (!next) return;
        next->next_word();
        if (next->is_at_end()) next_count();
    }

    void read_vertex(std::size_t number) {
        next_element("vertex " + std::to_string(number) + " of " + std::to_string(header.vertices) +
                     " is missing");
        const std::size_t at = lines.number();
        const double x = next_number(), y = next_number(), z = next_number();
        const double weight = header.coordinates == 4 ? next_number() : 1;
        soup.points.emplace_back(x / weight, y / weight, z / weight);
        soup.point_line.push_back(at);
        for (std::size_t i = 0; layout != OffLayout::lines && i < header.extras; ++i) next_number();
    }

    void read_face(std::size_t number) {
        next_element("face " + std::to_string(number) + " is missing");
        soup.polygon_line.push_back(lines.number());
        TextLine before = *line;
        const std::size_t count = next_integer("is not a number of corners of a face");
        std::vector<std::size_t>& polygon = soup.polygons.emplace_back();
        for (std::size_t corner = 0; corner < count; ++corner) {
            next_part();
            if (line->is_at_end())
                before.fail("corners were announced, but the line has fewer", before.next_word());
            polygon.push_back(next_integer("is no vertex number"));
        }
        if (layout != OffLayout::lines) require_corners(polygon);
        if (layout == OffLayout::face_colours) *line = TextLine(file, lines.number(), {});
    }

    /// Throws Error if a face has fewer than three corners, or corners that do not exist: then the text has
    /// another layout.
    void require_corners(const std::vector<std::size_t>& polygon) const {
        const auto is_there = [&](std::size_t corner) { return corner < header.vertices; };
        if (polygon.size() < 3 || !std::ranges::all_of(polygon, is_there))
            line->fail("ends a sequence that cannot be a face", {});
    }

    const std::filesystem::path& file;
    TextLines lines;
    std::optional<TextLine> line;
    OffLayout layout;
    OffHeader header;
    PolygonSoup soup;
};

std::optional<PolygonSoup> parse_off_as(const std::filesystem::path& file, std::string_view text,
                                        OffLayout layout) {
    try {
        return OffText(file, text, layout).parse();
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Parses a text in the layout that fits it. OFF ignores line ends, yet many files have more or fewer numbers
/// in a line than the keyword says. `words` is tried first, since it fits only if all words are used. If no
/// layout fits, throws the Error that `lines` gives.
PolygonSoup parse_off_text(const std::filesystem::path& file, std::string_view text) {
    for (const OffLayout layout : {OffLayout::words, OffLayout::lines, OffLayout::face_colours})
        if (auto soup = parse_off_as(file, text, layout)) return std::move(*soup);
    return OffText(file, text, OffLayout::lines).parse();
}

/// Parses a binary file: big-endian integers and floats behind the line of the keyword.
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
                            : parse_off_text(file, content);
}

}  // namespace sherd
