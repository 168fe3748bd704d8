// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/write_mesh.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>

#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// The shortest text that reads back as the same number.
void append(std::string& text, double value) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}
void append(std::string& text, std::size_t value) {
    text += std::to_string(value);
}
void append(std::string& text, const char* value) {
    text += value;
}

template <typename... Values>
void append_all(std::string& text, const Values&... values) {
    (append(text, values), ...);
}

/// Numbers of an OBJ file go on from one object to the next.
struct ObjCounts {
    std::size_t points = 0, texture = 0;
};

/// One object, complete in itself: its points, its texture points, its faces.
void append_object(std::string& text, const TriangleSheet& sheet, const std::vector<std::size_t>& triangles,
                   const std::vector<std::size_t>& points, ObjCounts& counts) {
    std::vector<std::size_t> point_number(sheet.points.size());
    for (const std::size_t i : points) {
        point_number[i] = ++counts.points;
        const auto& p = sheet.points[i];
        append_all(text, "v ", p.x(), " ", p.y(), " ", p.z(), "\n");
    }
    std::vector<std::array<std::size_t, 3>> texture_number(sheet.texture.empty() ? 0 : triangles.size());
    std::map<std::pair<double, double>, std::size_t> known;
    for (std::size_t i = 0; i < texture_number.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto& uv = sheet.texture[triangles[i]][corner];
            const auto [entry, is_new] = known.try_emplace({uv.x(), uv.y()}, counts.texture + 1);
            if (is_new) append_all(text, "vt ", uv.x(), " ", uv.y(), "\n");
            counts.texture += is_new;
            texture_number[i][corner] = entry->second;
        }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        text += 'f';
        for (int corner = 0; corner < 3; ++corner) {
            append_all(text, " ", point_number[sheet.triangles[triangles[i]][corner]]);
            if (!texture_number.empty()) append_all(text, "/", texture_number[i][corner]);
        }
        text += '\n';
    }
}

std::vector<std::size_t> points_of(const TriangleSheet& sheet, const std::vector<std::size_t>& triangles) {
    std::vector<std::size_t> points;
    for (const std::size_t t : triangles) {
        points.insert(points.end(), sheet.triangles[t].begin(), sheet.triangles[t].end());
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::string obj_text(const TriangleSheet& sheet) {
    std::string text;
    ObjCounts counts;
    std::vector<std::vector<std::size_t>> triangles(std::max<std::size_t>(sheet.group_names.size(), 1));
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        triangles[sheet.group.empty() ? 0 : sheet.group[t]].push_back(t);
    }
    if (sheet.group.empty()) {
        std::vector<std::size_t> all_points(sheet.points.size());
        for (std::size_t i = 0; i < all_points.size(); ++i) all_points[i] = i;
        append_object(text, sheet, triangles[0], all_points, counts);
        return text;
    }
    for (std::size_t group = 0; group < triangles.size(); ++group) {
        if (triangles[group].empty()) continue;
        append_all(text, "o ", sheet.group_names[group].c_str(), "\n");
        append_object(text, sheet, triangles[group], points_of(sheet, triangles[group]), counts);
    }
    return text;
}

template <typename Value>
void append_bytes(std::string& bytes, Value value) {
    static_assert(std::endian::native == std::endian::little, "the PLY header says little endian");
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string ply_header(const TriangleSheet& sheet) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    append_all(text, sheet.points.size(), "\nproperty double x\nproperty double y\nproperty double z\n");
    append_all(text, "element face ", sheet.triangles.size(), "\nproperty list uchar int vertex_indices\n");
    if (!sheet.group.empty()) text += "property int fragment\n";
    if (!sheet.quality.empty()) text += "property double quality\n";
    if (!sheet.texture.empty()) text += "property list uchar float texcoord\n";
    return text + "end_header\n";
}

std::string ply_bytes(const TriangleSheet& sheet) {
    std::string bytes = ply_header(sheet);
    for (const auto& p : sheet.points) {
        for (const double coordinate : p) append_bytes(bytes, coordinate);
    }
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        append_bytes(bytes, std::uint8_t{3});
        for (const std::int32_t point : sheet.triangles[t]) append_bytes(bytes, point);
        if (!sheet.group.empty()) append_bytes(bytes, sheet.group[t]);
        if (!sheet.quality.empty()) append_bytes(bytes, sheet.quality[t]);
        if (sheet.texture.empty()) continue;
        append_bytes(bytes, std::uint8_t{6});
        for (const auto& uv : sheet.texture[t]) {
            append_bytes(bytes, static_cast<float>(uv.x()));
            append_bytes(bytes, static_cast<float>(uv.y()));
        }
    }
    return bytes;
}

void check(const TriangleSheet& sheet, const std::string& file) {
    const auto require = [&](bool holds, const char* what) {
        if (!holds) throw Error(file + ": cannot write the mesh: " + what, Fault::run);
    };
    const std::size_t count = sheet.triangles.size();
    const auto fits = [&](const auto& values) { return values.empty() || values.size() == count; };
    require(fits(sheet.group) && fits(sheet.texture) && fits(sheet.quality),
            "group, texture and quality need one value a triangle");
    for (const auto& triangle : sheet.triangles) {
        for (const std::int32_t point : triangle) {
            require(point >= 0 && static_cast<std::size_t>(point) < sheet.points.size(),
                    "a triangle names a point that is not there");
        }
    }
    for (const std::int32_t group : sheet.group) {
        require(group >= 0 && static_cast<std::size_t>(group) < sheet.group_names.size(),
                "a triangle names a group that is not there");
    }
}

[[noreturn]] void fail(const fs::path& file, const fs::path& temporary, const std::string& reason) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw Error(file.string() + ": cannot be written: " + reason, Fault::run);
}

void replace_file(const fs::path& file, const std::string& bytes) {
    const fs::path temporary = file.string() + ".part";
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) fail(file, temporary, errno != 0 ? std::strerror(errno) : "write error");
    std::error_code failure;
    fs::rename(temporary, file, failure);
    if (failure) fail(file, temporary, failure.message());
}

}  // namespace

TriangleSheet triangle_sheet(const Mesh& mesh) {
    TriangleSheet sheet;
    // A mesh with removed elements has gaps in its numbers: count anew.
    std::vector<std::int32_t> number(mesh.num_vertices());
    for (const Vertex v : mesh.vertices()) {
        number[v.idx()] = static_cast<std::int32_t>(sheet.points.size());
        const Point& p = mesh.point(v);
        sheet.points.emplace_back(p.x(), p.y(), p.z());
    }
    const auto [texture, has_texture] = mesh.property_map<Face, FaceTexture>(property::texture);
    for (const Face face : mesh.faces()) {
        auto& triangle = sheet.triangles.emplace_back();
        auto corner = triangle.begin();
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) *corner++ = number[v.idx()];
        if (has_texture) sheet.texture.push_back(texture[face]);
    }
    return sheet;
}

void write_mesh(const TriangleSheet& sheet, const fs::path& file) {
    check(sheet, file.string());
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".obj") {
        replace_file(file, obj_text(sheet));
    } else if (extension == ".ply") {
        replace_file(file, ply_bytes(sheet));
    } else {
        throw Error(file.string() + ": cannot be written: unknown kind of mesh file `" + extension +
                        "`; known are .obj and .ply",
                    Fault::run);
    }
}

}  // namespace sherd
