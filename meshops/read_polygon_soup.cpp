// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "meshops/error.h"
#include "meshops/polygon_soup.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& file) {
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    if (!fs::exists(status)) throw Error(file.string() + ": no such mesh file");
    if (fs::is_directory(status)) throw Error(file.string() + ": is a folder, a mesh file is needed");
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        const char* reason = errno != 0 ? std::strerror(errno) : "read error";
        throw Error(file.string() + ": the mesh file cannot be read: " + reason);
    }
    return text;
}

/// Says where a reader that knows no more than "it failed" has stopped.
[[noreturn]] void fail_at(const fs::path& file, std::istringstream& stream, const std::string& text,
                          const std::string& format) {
    stream.clear();
    const auto position = std::min(static_cast<std::size_t>(stream.tellg()), text.size());
    const bool at_end = text.find_first_not_of(" \t\r\n", position) == text.npos;
    if (is_binary(text)) {
        throw Error(file.string() + ": damaged " + format + " file: " +
                    (at_end ? "it ends too early (truncated?)"
                            : "cannot be understood near byte " + std::to_string(position)));
    }
    // The position is behind what could not be read: step back over the end of that line.
    const std::size_t end = text.find_last_not_of(" \t\r\n", position == 0 ? 0 : position - 1);
    if (end == text.npos) throw Error(file.string() + ": the " + format + " file is empty");
    const std::size_t start = text.find_last_of('\n', end) + 1;
    const std::string line = text.substr(start, std::min(text.find_first_of("\r\n", start) - start, 80UL));
    const auto number = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(start), '\n');
    std::string lower = line;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool is_nan = lower.find("nan") != lower.npos || lower.find("inf") != lower.npos;
    throw Error(file.string() + ":" + std::to_string(number) + ": " +
                (is_nan   ? "a coordinate is NaN or infinite"
                 : at_end ? "the " + format + " file ends too early (truncated?)"
                          : "cannot be understood as " + format) +
                ": `" + line + "`");
}

/// Runs one of CGAL's readers, read(stream, points, polygons), on the text.
template <typename Read>
PolygonSoup parse_with(const fs::path& file, const std::string& text, const std::string& format, Read read) {
    PolygonSoup soup;
    soup.file = file;
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    bool is_read = false;
    try {
        is_read = read(stream, soup.points, soup.polygons);
    } catch (const std::exception&) {
        // A count in a damaged file may ask for more than there is memory, or break a promise CGAL checks.
        is_read = false;
    }
    if (!is_read) fail_at(file, stream, text, format);
    return soup;
}

PolygonSoup parse_off(const fs::path& file, const std::string& text) {
    // CGAL makes room for as many vertices and faces as the header says before it reads the first.
    std::istringstream stream(text);
    CGAL::File_header_OFF header;
    stream >> header;
    if (!stream) fail_at(file, stream, text, "OFF");
    const std::size_t elements = header.size_of_vertices() + header.size_of_facets();
    if (header.size_of_vertices() > text.size() || elements > text.size()) {
        throw Error(file.string() + ": the OFF file ends too early (truncated?): its header promises " +
                    std::to_string(header.size_of_vertices()) + " vertices and " +
                    std::to_string(header.size_of_facets()) + " faces");
    }
    return parse_with(file, text, "OFF", [](auto& stream, auto& points, auto& polygons) {
        return CGAL::IO::read_OFF(stream, points, polygons, CGAL::parameters::verbose(false));
    });
}

/// The face properties axis_x, axis_y and axis_z; empty when not all of them are there.
std::vector<Eigen::Vector3d> ply_axes(const std::string& text) {
    constexpr std::array<const char*, 3> names{"axis_x", "axis_y", "axis_z"};
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    CGAL::IO::internal::PLY_reader reader(false);
    std::vector<Eigen::Vector3d> axes;
    if (!reader.init(stream)) return axes;
    for (std::size_t e = 0; e < reader.number_of_elements(); ++e) {
        CGAL::IO::internal::PLY_element& element = reader.element(e);
        const auto has = [&](const char* name) { return element.has_property(name, double()); };
        const bool has_axes = element.name().starts_with("face") && std::ranges::all_of(names, has);
        for (std::size_t item = 0; item < element.number_of_items(); ++item) {
            for (std::size_t p = 0; p < element.number_of_properties(); ++p) element.property(p)->get(stream);
            if (!has_axes) continue;
            Eigen::Vector3d& axis = axes.emplace_back();
            for (int i = 0; i < 3; ++i) element.assign(axis[i], names[i]);
        }
    }
    return axes;
}

PolygonSoup parse_ply(const fs::path& file, const std::string& text) {
    if (!text.starts_with("ply")) {
        throw Error(file.string() + ":1: cannot be understood as PLY: does not begin with `ply`");
    }
    PolygonSoup soup = parse_with(file, text, "PLY", [](auto& stream, auto& points, auto& polygons) {
        return CGAL::IO::read_PLY(stream, points, polygons, CGAL::parameters::verbose(false));
    });
    soup.axis = ply_axes(text);
    return soup;
}

}  // namespace

PolygonSoup read_polygon_soup(const fs::path& file) {
    const std::string text = file_text(file);
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".ply") return parse_ply(file, text);
    if (extension == ".off") return parse_off(file, text);
    if (extension == ".stl") return parse_stl(file, text);
    if (extension != ".obj") {
        throw Error(file.string() + ": unknown kind of mesh file `" + extension +
                    "`; known are .obj, .ply, .off and .stl");
    }
    if (is_binary(text)) throw Error(file.string() + ": is binary, not the text of an OBJ file");
    return parse_obj(file, text);
}

}  // namespace sherd
