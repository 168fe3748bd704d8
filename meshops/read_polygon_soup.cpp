// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

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
