// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "meshops/error.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/text_line.h"
#include "meshops/soup/polygon_soup.h"

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

std::string extension_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

}  // namespace

PolygonSoup read_polygon_soup(const fs::path& file) {
    const std::string content = file_text(file);
    const std::string extension = extension_of(file);
    // parse_stl() looks for a byte order mark itself, since a binary STL file may begin with any bytes.
    if (extension == ".stl") return parse_stl(file, content);
    const std::string_view text = without_byte_order_mark(file, content);
    if (extension == ".ply") return parse_ply(file, text);
    if (extension == ".off") return parse_off(file, text);
    if (extension != ".obj") {
        throw Error(file.string() + ": unknown kind of mesh file `" + extension +
                    "`; known are .obj, .ply, .off and .stl");
    }
    if (is_binary(text)) throw Error(file.string() + ": is binary, not the text of an OBJ file");
    return parse_obj(file, text);
}

std::vector<double> read_vertex_property(const fs::path& file, const std::string& name) {
    if (extension_of(file) != ".ply")
        throw Error(file.string() + ": only a PLY file has properties of its vertices");
    const std::string content = file_text(file);
    return parse_ply_property(file, without_byte_order_mark(file, content), name);
}

}  // namespace sherd
