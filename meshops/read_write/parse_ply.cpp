// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_write/ply_header.h"
#include "meshops/read_write/text_line.h"
#include "meshops/soup/polygon_soup.h"

// CGAL's reader is not used: it fails on malformed headers (a property before any element, integer
// coordinates), and allocates memory for any number of values that a list claims to have.
namespace sherd {
namespace {

struct Range {
    double low, high;
};

template <class Integer>
constexpr Range range{std::numeric_limits<Integer>::lowest(), std::numeric_limits<Integer>::max()};

Range range_of(PlyType type) {
    constexpr std::array<Range, 6> ranges{range<std::int8_t>,   range<std::uint8_t>, range<std::int16_t>,
                                          range<std::uint16_t>, range<std::int32_t>, range<std::uint32_t>};
    return ranges.at(static_cast<std::size_t>(type));
}

double binary_value(PlyType type, const char* bytes, std::endian order) {
    switch (type) {
        case PlyType::int8:
            return number_at<std::int8_t>(bytes, order);
        case PlyType::uint8:
            return number_at<std::uint8_t>(bytes, order);
        case PlyType::int16:
            return number_at<std::int16_t>(bytes, order);
        case PlyType::uint16:
            return number_at<std::uint16_t>(bytes, order);
        case PlyType::int32:
            return number_at<std::int32_t>(bytes, order);
        case PlyType::uint32:
            return number_at<std::uint32_t>(bytes, order);
        case PlyType::float32:
            return number_at<float>(bytes, order);
        default:
            return number_at<double>(bytes, order);
    }
}

/// Reads the rows after a header, in order. A row has a list of values for each property; a single value is a
/// list of one. A double holds every number of PLY exactly.
class PlyRows {
  public:
    PlyRows(const std::filesystem::path& file, std::string_view content, const PlyHeader& header)
        : file(file),
          format(header.format),
          text_size(content.size()),
          lines(file, content),
          bytes(content.substr(header.bytes)) {
        while (lines.number() < header.lines) lines.next();
    }

    /// Reads the next row, which is row `number` of the element `of`. Returns the values of each property;
    /// they are valid until the next call.
    const std::vector<std::vector<double>>& next(const PlyElement& of, std::size_t number) {
        element = &of;
        row = number;
        values.resize(of.properties.size());
        first_line = 0;
        for (std::size_t p = 0; p < values.size(); ++p) {
            const PlyProperty& property = of.properties[p];
            values[p].resize(property.count ? list_size(property) : 1);
            for (double& value : values[p]) value = next_value(property.type);
        }
        if (line && !line->is_at_end())
            line->fail("is one value too many: " + place() + " is complete before it", line->next_word());
        return values;
    }
    std::size_t line_number() const { return first_line; }  ///< line where the row begins; 0 in a binary file

  private:
    std::string place() const { return element->name + " " + std::to_string(row); }

    [[noreturn]] void fail(const std::string& what) const {
        const std::string at = format == PlyFormat::text ? ":" + std::to_string(lines.number()) : "";
        throw Error(file.string() + at + ": " + place() + ": " + what);
    }
    [[noreturn]] void fail_at_end() const {
        throw Error(file.string() + ": the PLY file ends too early (truncated?): in " + place() + " of " +
                    std::to_string(element->rows));
    }

    std::size_t list_size(const PlyProperty& property) {
        const double size = next_value(*property.count);
        const std::size_t left = format == PlyFormat::text ? text_size : bytes.size();
        if (size < 0)
            fail("its list " + property.name + " has " + std::to_string(static_cast<std::int64_t>(size)) +
                 " values");
        if (least_bytes(format, property.type, static_cast<std::size_t>(size)) > left)
            fail("its list " + property.name + " has " + std::to_string(static_cast<std::int64_t>(size)) +
                 " values, more than are left in the file");
        return static_cast<std::size_t>(size);
    }

    double next_value(PlyType type) {
        return format == PlyFormat::text ? next_text_value(type) : next_binary_value(type);
    }

    double next_text_value(PlyType type) {
        if (!line || line->is_at_end()) line = lines.next_with_words();
        if (!line) fail_at_end();
        if (first_line == 0) first_line = lines.number();
        TextLine before = *line;
        const double value = line->next_number();
        if (!is_integer(type)) return value;
        const auto [low, high] = range_of(type);
        if (!(value >= low && value <= high && value == std::floor(value)))
            before.fail(
                "is no number of the type " + std::string(name_of(type)) + " that the header declares",
                before.next_word());
        return value;
    }

    double next_binary_value(PlyType type) {
        const std::size_t size = bytes_of(type);
        if (bytes.size() < size) fail_at_end();
        const double value = binary_value(
            type, bytes.data(), format == PlyFormat::big_endian ? std::endian::big : std::endian::little);
        bytes.remove_prefix(size);
        return value;
    }

    const std::filesystem::path& file;
    PlyFormat format;
    std::size_t text_size;
    TextLines lines;               ///< unread lines of a text file
    std::optional<TextLine> line;  ///< rest of the current line of a text file
    std::string_view bytes;        ///< unread bytes of a binary file
    const PlyElement* element = nullptr;
    std::size_t row = 0, first_line = 0;
    std::vector<std::vector<double>> values;
};

/// Collects the colours of the rows of an element.
class ColourColumns {
  public:
    explicit ColourColumns(const PlyElement& element) : element(element) {
        for (const char* name : {"red", "green", "blue", "alpha"}) {
            const auto found = element.find({name, std::string("diffuse_") + name});
            if (found && !element.properties[*found].count) columns.push_back(*found);
            if (columns.size() < 3 && !found) break;
        }
    }

    /// Adds the colour of a row, if the element has colours.
    void add(const std::vector<std::vector<double>>& row) {
        if (columns.size() < 3) return;
        auto& parts = values.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            parts[i] = row[columns[i]][0];
            double& most = i < 3 ? most_colour : most_opacity;
            if (std::isfinite(parts[i])) most = std::max(most, parts[i]);
        }
    }

    std::vector<Colour> colours() const {
        std::vector<Colour> result;
        for (std::size_t row = 0; row < values.size(); ++row) {
            Colour& colour = result.emplace_back(white);
            for (std::size_t i = 0; i < columns.size(); ++i)
                colour[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share(row, i), 0.0, 1.0)));
        }
        return result;
    }

    /// Returns the values of property number `column` in all rows as intensities from 0 to 1; nullopt if the
    /// property is no component of a colour.
    std::optional<std::vector<double>> shares(std::size_t column) const {
        const auto found = std::ranges::find(columns, column);
        if (columns.size() < 3 || found == columns.end()) return std::nullopt;
        std::vector<double> result;
        for (std::size_t row = 0; row < values.size(); ++row)
            result.push_back(share(row, static_cast<std::size_t>(found - columns.begin())));
        return result;
    }

  private:
    double share(std::size_t row, std::size_t i) const {
        return std::isfinite(values[row][i]) ? values[row][i] / full(i) : 0;
    }
    /// Returns the value that means full intensity of component i. Usually this is the largest number of an
    /// integer type, and 1 for other types. But some files have values from 0 to 255 in all types; the
    /// largest value in the file shows which.
    double full(std::size_t i) const {
        constexpr double brighter_than_white = 16;  // intensities up to this occur where 1 is white
        const PlyType type = element.properties[columns[i]].type;
        const double most = i < 3 ? most_colour : most_opacity;
        if (is_integer(type)) return most <= 255 ? 255 : range_of(type).high;
        return most > brighter_than_white ? 255 : 1;
    }

    const PlyElement& element;
    std::vector<std::size_t> columns;  ///< numbers of the properties with red, green, blue and perhaps
                                       ///< opacity; fewer than 3: no colours
    std::vector<std::array<double, 4>> values;
    double most_colour = 0, most_opacity = 0;
};

/// Collects those attributes of an element (vertices or faces) that are numbers or vectors, from its rows.
template <class Element>
class AttributeColumns {
  public:
    explicit AttributeColumns(const PlyElement& element) {
        visit_numbers<Element>([&](const auto& attribute) {
            for (const std::string& name : ply_names(attribute))
                if (const auto found = element.find({name}); found && !element.properties[*found].count)
                    columns[name] = {*found, {}};
        });
    }

    void add(const std::vector<std::vector<double>>& row) {
        for (auto& [name, column] : columns) column.values.push_back(row[column.number][0]);
    }

    void give(SurfaceLook& look) const {
        visit_numbers<Element>([&](const auto& attribute) {
            const std::vector<std::string> names = ply_names(attribute);
            if (!std::ranges::all_of(names, [&](const auto& name) { return columns.contains(name); })) return;
            auto& list = look.*attribute.list;
            const std::size_t before = list.size(), count = columns.at(names[0]).values.size();
            list.resize(before + count, attribute.missing());
            for (std::size_t i = 0; i < names.size(); ++i)
                for (std::size_t row = 0; row < count; ++row)
                    numbers_of(list[before + row])[i] = columns.at(names[i]).values[row];
        });
    }

  private:
    struct Column {
        std::size_t number;
        std::vector<double> values;
    };
    std::map<std::string, Column> columns;
};

void read_vertices(PlyRows& rows, const PlyElement& element, PolygonSoup& soup) {
    std::array<std::size_t, 3> column;
    for (const auto& [i, name] : {std::pair{0, "x"}, {1, "y"}, {2, "z"}}) {
        const auto found = element.find({name});
        if (!found || element.properties[*found].count)
            throw Error(soup.file.string() + ":" + std::to_string(element.line) + ": element " +
                        element.name + " of the PLY file needs a number `" + name +
                        "`: write `property float " + name + "`");
        column[i] = *found;
    }
    ColourColumns colours(element);
    AttributeColumns<Vertex> attributes(element);
    for (std::size_t row = 0; row < element.rows; ++row) {
        const auto& values = rows.next(element, row);
        colours.add(values);
        attributes.add(values);
        soup.points.emplace_back(values[column[0]][0], values[column[1]][0], values[column[2]][0]);
        if (rows.line_number() > 0) soup.point_line.push_back(rows.line_number());
    }
    soup.look.vertex_colour = colours.colours();
    attributes.give(soup.look);
}

bool has_vertices(const PlyElement& element) {
    return element.name == "vertex" || element.name == "vertices";
}

bool has_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "faces";
}

void skip(PlyRows& rows, const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::size_t row = 0; row < element.rows; ++row) rows.next(element, row);
}

/// Returns the index of the property `name`, which must have one value. Throws Error if there is no such
/// property.
std::size_t single_property(const std::filesystem::path& file, const PlyElement& element,
                            const std::string& name) {
    std::string known;
    for (const PlyProperty& property : element.properties)
        if (!property.count) known += (known.empty() ? "" : ", ") + property.name;
    const auto found = element.find({name});
    if (!found || element.properties[*found].count)
        throw Error(file.string() + ":" + std::to_string(element.line) + ": element " + element.name +
                    " of the PLY file has no number `" + name + "`; it has " +
                    (known.empty() ? "none" : known));
    return *found;
}

std::vector<std::size_t> corners(const std::vector<double>& values) {
    std::vector<std::size_t> polygon;
    // A negative number becomes a large one, which check_polygon_soup() reports as an index out of range and
    // prints as negative.
    for (const double value : values)
        polygon.push_back(static_cast<std::size_t>(static_cast<std::int64_t>(value)));
    return polygon;
}

/// Returns the index of the property that lists the vertices of a face or strip. Throws Error if there is
/// none.
std::size_t vertex_list(const std::filesystem::path& file, const PlyElement& element) {
    const auto list = element.find({"vertex_indices", "vertex_index"});
    if (!list || !element.properties[*list].count || !is_integer(element.properties[*list].type))
        throw Error(file.string() + ":" + std::to_string(element.line) + ": element " + element.name +
                    " of the PLY file needs a list of vertex numbers: write `property list uchar int "
                    "vertex_indices`");
    return *list;
}

/// Reads strips of triangles, as scans of the 1990s have them. Each vertex makes a triangle with the two
/// vertices before it, and every second triangle is turned over. The number -1 begins another strip. A
/// repeated vertex makes no triangle, but counts, so that the following triangles change their orientation.
void read_strips(PlyRows& rows, const PlyElement& element, PolygonSoup& soup) {
    const std::size_t list = vertex_list(soup.file, element);
    for (std::size_t row = 0; row < element.rows; ++row) {
        const std::vector<std::size_t> strip = corners(rows.next(element, row)[list]);
        std::size_t begin = 0;
        for (std::size_t i = 0; i < strip.size(); ++i) {
            if (strip[i] == static_cast<std::size_t>(-1)) begin = i + 1;
            if (i < begin + 2) continue;
            const bool is_turned = (i - begin) % 2 == 1;
            const std::size_t a = strip[i - 2], b = strip[i - 1], c = strip[i];
            if (a == b || b == c || a == c) continue;
            soup.polygons.push_back(is_turned ? std::vector{b, a, c} : std::vector{a, b, c});
            if (rows.line_number() > 0) soup.polygon_line.push_back(rows.line_number());
        }
    }
}

void read_faces(PlyRows& rows, const PlyElement& element, PolygonSoup& soup) {
    const std::size_t list = vertex_list(soup.file, element);
    ColourColumns colours(element);
    AttributeColumns<Face> attributes(element);
    for (std::size_t row = 0; row < element.rows; ++row) {
        const auto& values = rows.next(element, row);
        colours.add(values);
        attributes.add(values);
        soup.polygons.push_back(corners(values[list]));
        if (rows.line_number() > 0) soup.polygon_line.push_back(rows.line_number());
    }
    soup.look.face_colour = colours.colours();
    attributes.give(soup.look);
}

}  // namespace

PolygonSoup parse_ply(const std::filesystem::path& file, std::string_view content) {
    const PlyHeader header = parse_ply_header(file, content);
    PolygonSoup soup;
    soup.file = file;
    PlyRows rows(file, content, header);
    const bool any_faces = std::ranges::any_of(
        header.elements, [](const PlyElement& element) { return has_faces(element) && element.rows > 0; });
    for (const PlyElement& element : header.elements) {
        if (has_vertices(element)) {
            read_vertices(rows, element, soup);
        } else if (has_faces(element)) {
            read_faces(rows, element, soup);
        } else if (element.name == "tristrips" && !any_faces) {
            read_strips(rows, element, soup);
        } else {
            skip(rows, element);
            if (element.rows > 0)
                soup.warnings.push_back(std::to_string(element.rows) +
                                        (element.rows == 1 ? " row" : " rows") + " of element `" +
                                        element.name + (element.rows == 1 ? "` was" : "` were") +
                                        " skipped (line " + std::to_string(element.line) + ")");
        }
    }
    return soup;
}

std::vector<double> parse_ply_property(const std::filesystem::path& file, std::string_view content,
                                       const std::string& name) {
    const PlyHeader header = parse_ply_header(file, content);
    PlyRows rows(file, content, header);
    std::vector<double> values;
    for (const PlyElement& element : header.elements) {
        if (!has_vertices(element)) {
            skip(rows, element);
            continue;
        }
        const std::size_t column = single_property(file, element, name);
        ColourColumns colours(element);
        for (std::size_t row = 0; row < element.rows; ++row) {
            const auto& of_row = rows.next(element, row);
            values.push_back(of_row[column][0]);
            colours.add(of_row);
        }
        return colours.shares(column).value_or(values);
    }
    return values;
}

}  // namespace sherd
