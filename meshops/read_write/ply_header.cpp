// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "meshops/error.h"
#include "meshops/read_write/text_line.h"

namespace sherd {
namespace {

struct TypeNames {
    PlyType type;
    std::string_view name, other_name;
    std::size_t bytes;
};
constexpr std::array<TypeNames, 8> types{{{PlyType::int8, "char", "int8", 1},
                                          {PlyType::uint8, "uchar", "uint8", 1},
                                          {PlyType::int16, "short", "int16", 2},
                                          {PlyType::uint16, "ushort", "uint16", 2},
                                          {PlyType::int32, "int", "int32", 4},
                                          {PlyType::uint32, "uint", "uint32", 4},
                                          {PlyType::float32, "float", "float32", 4},
                                          {PlyType::float64, "double", "float64", 8}}};

const TypeNames& names_of(PlyType type) {
    return *std::ranges::find(types, type, &TypeNames::type);
}

PlyType read_type(TextLine& line) {
    const std::string_view word = line.next_word();
    for (const TypeNames& known : types)
        if (word == known.name || word == known.other_name) return known.type;
    line.fail("is no type of PLY; known are char, uchar, short, ushort, int, uint, float and double", word);
}

void require_end(TextLine& line, const std::string& form) {
    if (!line.is_at_end()) line.fail("is one too many in the PLY header; write " + form, line.next_word());
}

PlyFormat read_format(TextLine& line) {
    const std::string form =
        "`format ascii 1.0`, `format binary_little_endian 1.0` or `format binary_big_endian 1.0`";
    const std::string_view name = line.next_word(), version = line.next_word();
    const bool is_text = name == "ascii", is_big = name == "binary_big_endian";
    if (!is_text && !is_big && name != "binary_little_endian")
        line.fail("is no format of PLY; write " + form, name);
    if (version != "1.0") line.fail("is no known version of PLY; write " + form, version);
    require_end(line, form);
    return is_text ? PlyFormat::text : is_big ? PlyFormat::big_endian : PlyFormat::little_endian;
}

PlyElement read_element(TextLine& line, const PlyHeader& header, std::size_t number) {
    const std::string form = "`element NAME ROWS`";
    PlyElement element;
    element.line = number;
    element.name = line.next_word();
    const std::string_view rows = line.next_word();
    const auto [end, failure] = std::from_chars(rows.data(), rows.data() + rows.size(), element.rows);
    if (element.name.empty() || failure != std::errc() || end != rows.data() + rows.size())
        line.fail("is no number of rows in the PLY header; write " + form, rows);
    require_end(line, form);
    if (std::ranges::find(header.elements, element.name, &PlyElement::name) != header.elements.end())
        line.fail("is declared twice: the PLY header has two elements of this name", element.name);
    return element;
}

void read_property(TextLine& line, PlyHeader& header) {
    const std::string form = "`property TYPE NAME` or `property list TYPE TYPE NAME`";
    if (header.elements.empty())
        line.fail(
            "stands before any `element` in the PLY header; put it after the element to which it belongs",
            "property");
    TextLine ahead = line;
    PlyProperty property;
    if (ahead.next_word() == "list") {
        line = ahead;
        property.count = read_type(line);
        if (!is_integer(*property.count))
            line.fail("cannot be the type of a list's length in the PLY header; use uchar",
                      name_of(*property.count));
    }
    property.type = read_type(line);
    property.name = line.next_word();
    if (property.name.empty()) line.fail("the property has no name; write " + form, {});
    require_end(line, form);
    PlyElement& element = header.elements.back();
    if (element.find({property.name}))
        line.fail("is declared twice: element " + element.name + " has two properties of this name",
                  property.name);
    element.properties.push_back(property);
}

void require_rows_fit(const std::filesystem::path& file, const PlyHeader& header, std::size_t available) {
    for (const PlyElement& element : header.elements) {
        std::size_t row = 0;
        for (const PlyProperty& property : element.properties)
            row += least_bytes(header.format, property.count.value_or(property.type), 1) +
                   (header.format == PlyFormat::text ? 1 : 0);
        // The last value of a text may end without a space.
        const std::size_t room = available + (header.format == PlyFormat::text ? 1 : 0);
        if (row > 0 && element.rows > room / row)
            throw Error(file.string() + ":" + std::to_string(element.line) +
                        ": the PLY file ends too early (truncated?): its header promises " +
                        std::to_string(element.rows) + " rows of element " + element.name + " of at least " +
                        std::to_string(row) + " bytes each, and " + std::to_string(available) +
                        " bytes follow it");
    }
}

}  // namespace

std::size_t bytes_of(PlyType type) {
    return names_of(type).bytes;
}

std::string_view name_of(PlyType type) {
    return names_of(type).name;
}

bool is_integer(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

std::optional<std::size_t> PlyElement::find(std::initializer_list<std::string_view> names) const {
    const auto found = std::ranges::find_if(properties, [&](const PlyProperty& property) {
        return std::ranges::find(names, property.name) != names.end();
    });
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
}

std::size_t least_bytes(PlyFormat format, PlyType type, std::size_t values) {
    if (format == PlyFormat::text) return values == 0 ? 0 : 2 * values - 1;
    return values * bytes_of(type);
}

PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view content) {
    TextLines lines(file, content);
    PlyHeader header;
    std::optional<TextLine> line = lines.next();
    if (!line || line->next_word() != "ply" || !line->is_at_end())
        throw Error(file.string() + ":1: is not a PLY file: it does not begin with a line `ply`");
    std::optional<PlyFormat> format;
    while ((line = lines.next_with_words())) {
        const std::string_view keyword = line->next_word();
        if (keyword == "end_header") break;
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format")
            format = read_format(*line);
        else if (keyword == "element")
            header.elements.push_back(read_element(*line, header, lines.number()));
        else if (keyword == "property")
            read_property(*line, header);
        else
            line->fail(
                "is no keyword of a PLY header; known are format, comment, obj_info, element, property and "
                "end_header",
                keyword.substr(0, 40));
    }
    if (!line)
        throw Error(file.string() +
                    ": the PLY file ends too early (truncated?): its header has no `end_header`");
    if (!format)
        throw Error(file.string() +
                    ": the PLY header has no line `format`; write `format ascii 1.0` for a text");
    header.format = *format;
    header.lines = lines.number();
    header.bytes = content.size() - lines.remaining().size();
    require_rows_fit(file, header, content.size() - header.bytes);
    return header;
}

}  // namespace sherd
