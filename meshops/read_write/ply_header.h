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

/// A line `property TYPE NAME` or `property list COUNT TYPE NAME`.
struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count;  ///< type of a list's length; none: a single value
};

/// An element `element NAME ROWS` with its properties: each row has a value or a list for each of them.
struct PlyElement {
    std::string name;
    std::size_t rows = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;  ///< number of its line, from 1

    /// Number of the property that has one of these names; none if there is none.
    std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
};

enum class PlyFormat { text, little_endian, big_endian };

/// The header of a PLY file (Turk, The PLY Polygon File Format, 1994).
struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t lines = 0;  ///< number of its lines
    std::size_t bytes = 0;  ///< offset of the first row
};

/// Reads the header at the start of a file's content. Throws Error with file, line and what to do about it if
/// anything is not understood, and if the file is too small for the rows that the header announces, so that
/// memory is only allocated for data that exist.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view content);

/// The minimum number of bytes (characters, in a text) of `values` values of a type.
std::size_t least_bytes(PlyFormat format, PlyType type, std::size_t values);

}  // namespace sherd
