// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/toml_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "meshops/error.h"
#include "meshops/read_write/text_line.h"

namespace sherd {

namespace {

/// Returns a text with line feeds. TOML ends lines with LF or CR LF; a text whose lines end with CR alone
/// gets LF instead.
std::string with_line_feeds(std::string text) {
    if (text.find('\n') == text.npos) std::ranges::replace(text, '\r', '\n');
    return text;
}

}  // namespace

std::string read_toml_text(const std::filesystem::path& file, std::string_view kind) {
    const auto fail = [&](const std::string& reason) {
        return Error(
            fmt::format("{}: cannot read the {}: {}; give a TOML file", file.string(), kind, reason));
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw fail("it is a directory");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw fail(std::generic_category().message(errno));
    for (const char* ending : {".obj", ".ply", ".off", ".stl"})
        if (file.extension() == ending) throw fail("it is a mesh, which a scene names as mesh = \"FILE\"");
    try {
        const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        if (text.starts_with("\x89HDF")) throw fail("it is an HDF5 file, as recordings are");
        return with_line_feeds(std::string(without_byte_order_mark(file, text)));
    } catch (const std::ios_base::failure&) {
        throw fail(std::generic_category().message(errno));
    }
}

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        throw Error(
            fmt::format("{}:{}:{}: TOML syntax: {}", file.string(), at.line, at.column, error.description()));
    }
}

}  // namespace sherd
