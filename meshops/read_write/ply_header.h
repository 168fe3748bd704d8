// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// The number types of PLY files. Each has two names, such as `uchar` and `uint8`.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);
std::string_view name_of(PlyType type);
bool is_integer(PlyType type);

/// A line `property TYPE NAME` or `property list COUNT TYPE NAME` of a header.
struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count;  ///< type of the length of a list; nullopt: a single value
};

/// An element, with the line `element NAME ROWS` in the header, and its properties. In the file it has `rows`
/// rows, each with a value or a list for each property.
struct PlyElement {
    std::string name;
    std::size_t rows = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;  ///< number of the line of the element, from 1

    /// Returns the index of the first property with one of these names; nullopt if there is none.
    std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
};

enum class PlyFormat { text, little_endian, big_endian };

/// The header of a PLY file (Turk, The PLY Polygon File Format, 1994).
struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t lines = 0;  ///< number of lines of the header
    std::size_t bytes = 0;  ///< offset of the first row from the beginning of the file
};

/// Reads the header at the start of `content`, the content of a file. Throws Error with file, line and advice
/// if a part of the header is not understood, or if the file is too small for the rows that the header
/// announces; thus memory is only allocated for data that exist.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view content);

/// Returns the smallest number of bytes that `values` values of `type` can take in a file. In a text, a value
/// has at least one character, and a blank separates it from the next.
std::size_t least_bytes(PlyFormat format, PlyType type, std::size_t values);

}  // namespace sherd
