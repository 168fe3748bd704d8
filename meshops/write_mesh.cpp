// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/write_mesh.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <utility>

#include "meshops/error.h"
#include "meshops/material_library.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_mesh.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Appends the shortest text that reads back as the same number.
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

/// The state that is carried from one object of an OBJ file to the next: counts, and the current groups and
/// material.
struct ObjState {
    std::size_t points = 0, texture = 0;
    GroupNames names;
    FaceMaterial material;
};

/// Appends the lines that put the following faces into exactly these groups. Only an object's name may have
/// several words; `has_objects` tells whether any of the names has.
void append_named_groups(std::string& text, const GroupNames& names, bool has_objects) {
    std::string group = "g", object = "o";
    if (names)
        for (const std::string& name : *names)
            append_all(name.find(' ') == name.npos ? group : object, " ", name.c_str());
    append_all(text, group.c_str(), "\n");
    if (has_objects) append_all(text, object.c_str(), "\n");
}

bool has_objects(const TriangleSheet& sheet) {
    const auto is_long = [](const std::string& name) { return name.find(' ') != name.npos; };
    return std::ranges::any_of(sheet.named_groups, [&](const GroupNames& names) {
        return names && std::ranges::any_of(*names, is_long);
    });
}

/// Appends one complete object: its points, texture points and faces.
void append_object(std::string& text, const TriangleSheet& sheet, const std::vector<std::size_t>& triangles,
                   const std::vector<std::size_t>& points, ObjState& state) {
    std::vector<std::size_t> point_number(sheet.points.size());
    for (const std::size_t i : points) {
        point_number[i] = ++state.points;
        const auto& p = sheet.points[i];
        append_all(text, "v ", p.x(), " ", p.y(), " ", p.z(), "\n");
    }
    std::vector<std::array<std::size_t, 3>> texture_number(sheet.texture.empty() ? 0 : triangles.size());
    std::map<std::pair<double, double>, std::size_t> known;
    for (std::size_t i = 0; i < texture_number.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto& uv = sheet.texture[triangles[i]][corner];
            const auto [entry, is_new] = known.try_emplace({uv.x(), uv.y()}, state.texture + 1);
            if (is_new) append_all(text, "vt ", uv.x(), " ", uv.y(), "\n");
            state.texture += is_new;
            texture_number[i][corner] = entry->second;
        }
    }
    const bool objects = has_objects(sheet);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!sheet.named_groups.empty() && sheet.named_groups[triangles[i]] != state.names) {
            state.names = sheet.named_groups[triangles[i]];
            append_named_groups(text, state.names, objects);
        }
        if (!sheet.material.empty() && !is_same(sheet.material[triangles[i]], state.material)) {
            state.material = sheet.material[triangles[i]];
            append_all(text, "usemtl ", material_name(state.material).c_str(), "\n");
        }
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

std::string obj_text(const TriangleSheet& sheet, const fs::path& file) {
    std::string text;
    if (!sheet.material.empty())
        append_all(text, "mtllib ", material_file(file).filename().string().c_str(), "\n");
    ObjState state;
    std::vector<std::vector<std::size_t>> triangles(std::max<std::size_t>(sheet.group_names.size(), 1));
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        triangles[sheet.group.empty() ? 0 : sheet.group[t]].push_back(t);
    }
    if (sheet.group.empty()) {
        std::vector<std::size_t> all_points(sheet.points.size());
        for (std::size_t i = 0; i < all_points.size(); ++i) all_points[i] = i;
        append_object(text, sheet, triangles[0], all_points, state);
        return text;
    }
    for (std::size_t group = 0; group < triangles.size(); ++group) {
        if (triangles[group].empty()) continue;
        append_all(text, "o ", sheet.group_names[group].c_str(), "\n");
        append_object(text, sheet, triangles[group], points_of(sheet, triangles[group]), state);
    }
    return text;
}

constexpr const char* colour_properties = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

std::string ply_header(const TriangleSheet& sheet) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    append_all(text, sheet.points.size(), "\nproperty double x\nproperty double y\nproperty double z\n");
    if (!sheet.point_colour.empty()) text += colour_properties;
    append_all(text, "element face ", sheet.triangles.size(), "\nproperty list uchar int vertex_indices\n");
    if (!sheet.colour.empty()) text += colour_properties;
    if (!sheet.group.empty()) text += "property int fragment\n";
    if (!sheet.quality.empty()) text += "property double quality\n";
    if (!sheet.texture.empty()) text += "property list uchar float texcoord\n";
    if (!sheet.axis.empty())
        text += "property double axis_x\nproperty double axis_y\nproperty double axis_z\n";
    return text + "end_header\n";
}

void append_texture(std::string& bytes, const FaceTexture& texture) {
    append_little_endian(bytes, std::uint8_t{6});
    for (const auto& uv : texture)
        for (const double coordinate : uv) append_little_endian(bytes, static_cast<float>(coordinate));
}

std::string ply_bytes(const TriangleSheet& sheet) {
    std::string bytes = ply_header(sheet);
    const auto append_colour = [&bytes](const Colour& colour) {
        for (const std::uint8_t part : colour) append_little_endian(bytes, part);
    };
    for (std::size_t i = 0; i < sheet.points.size(); ++i) {
        for (const double coordinate : sheet.points[i]) append_little_endian(bytes, coordinate);
        if (!sheet.point_colour.empty()) append_colour(sheet.point_colour[i]);
    }
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        append_little_endian(bytes, std::uint8_t{3});
        for (const std::int32_t point : sheet.triangles[t]) append_little_endian(bytes, point);
        if (!sheet.colour.empty()) append_colour(sheet.colour[t]);
        if (!sheet.group.empty()) append_little_endian(bytes, sheet.group[t]);
        if (!sheet.quality.empty()) append_little_endian(bytes, sheet.quality[t]);
        if (!sheet.texture.empty()) append_texture(bytes, sheet.texture[t]);
        if (sheet.axis.empty()) continue;
        for (const double coordinate : sheet.axis[t]) append_little_endian(bytes, coordinate);
    }
    return bytes;
}

std::string off_text(const TriangleSheet& sheet) {
    std::string text;
    append_all(text, "OFF\n", sheet.points.size(), " ", sheet.triangles.size(), " 0\n");
    for (const auto& p : sheet.points) append_all(text, p.x(), " ", p.y(), " ", p.z(), "\n");
    for (const auto& [a, b, c] : sheet.triangles)
        append_all(text, "3 ", std::size_t(a), " ", std::size_t(b), " ", std::size_t(c), "\n");
    return text;
}

void check(const TriangleSheet& sheet, const std::string& file) {
    const auto require = [&](bool holds, const char* what) {
        if (!holds) throw Error(file + ": cannot write the mesh: " + what, Fault::run);
    };
    const std::size_t count = sheet.triangles.size();
    const auto fits = [&](const auto& values) { return values.empty() || values.size() == count; };
    require(fits(sheet.group) && fits(sheet.texture) && fits(sheet.quality) && fits(sheet.named_groups) &&
                fits(sheet.axis) && fits(sheet.colour) && fits(sheet.material),
            "group, texture, quality, axis, material and colour need one value a triangle");
    require(sheet.point_colour.empty() || sheet.point_colour.size() == sheet.points.size(),
            "colours of points need one value a point");
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

std::string lower_extension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

/// Only a name of one word is a group in OBJ; others would be objects.
GroupNames as_groups(const GroupNames& names) {
    if (!names) return names;
    std::vector<std::string> words = *names;
    for (std::string& word : words) std::ranges::replace(word, ' ', '_');
    return std::make_shared<const std::vector<std::string>>(std::move(words));
}

}  // namespace

TriangleSheet triangle_sheet(const Mesh& mesh) {
    TriangleSheet sheet;
    // A mesh with removed elements has gaps in its numbers, so they are counted anew.
    std::vector<std::int32_t> number(mesh.num_vertices());
    for (const Vertex v : mesh.vertices()) {
        number[v.idx()] = static_cast<std::int32_t>(sheet.points.size());
        const Point& p = mesh.point(v);
        sheet.points.emplace_back(p.x(), p.y(), p.z());
    }
    const auto [texture, has_texture] = mesh.property_map<Face, FaceTexture>(property::texture);
    const auto [groups, has_groups] = mesh.property_map<Face, GroupNames>(property::groups);
    const auto [axis, has_axis] = mesh.property_map<Face, Eigen::Vector3d>(property::axis);
    const auto [material, has_material] = mesh.property_map<Face, FaceMaterial>(property::surface_material);
    for (const Face face : mesh.faces()) {
        auto& triangle = sheet.triangles.emplace_back();
        auto corner = triangle.begin();
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) *corner++ = number[v.idx()];
        if (has_texture) sheet.texture.push_back(texture[face]);
        if (has_groups) sheet.named_groups.push_back(groups[face]);
        if (has_axis) sheet.axis.push_back(axis[face]);
        if (has_material) sheet.material.push_back(material[face]);
    }
    return sheet;
}

void add_group(TriangleSheet& all, const TriangleSheet& mesh, const std::string& name) {
    const auto first = static_cast<std::int32_t>(all.points.size());
    const std::size_t before = all.triangles.size(), count = mesh.triangles.size();
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
    all.group.resize(before + count, static_cast<std::int32_t>(all.group_names.size()));
    all.group_names.push_back(name);
    if (!mesh.texture.empty() || !all.texture.empty()) {
        all.texture.resize(before + count,
                           {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
        std::ranges::copy(mesh.texture, all.texture.begin() + static_cast<std::ptrdiff_t>(before));
    }
    if (!mesh.material.empty() || !all.material.empty()) {
        all.material.resize(before + count);
        std::ranges::copy(mesh.material, all.material.begin() + static_cast<std::ptrdiff_t>(before));
    }
    if (!mesh.named_groups.empty() || !all.named_groups.empty()) {
        all.named_groups.resize(before + count);
        for (std::size_t i = 0; i < mesh.named_groups.size(); ++i)
            all.named_groups[before + i] = as_groups(mesh.named_groups[i]);
    }
}

bool can_write_mesh(const fs::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".obj" || extension == ".ply" || extension == ".off";
}

std::string mesh_bytes(const TriangleSheet& sheet, const fs::path& file) {
    check(sheet, file.string());
    const std::string extension = lower_extension(file);
    if (extension == ".obj") return obj_text(sheet, file);
    if (extension == ".ply") return ply_bytes(sheet);
    if (extension == ".off") return off_text(sheet);
    throw Error(file.string() + ": cannot be written: unknown kind of mesh file `" + extension +
                    "`; known are .obj, .ply and .off",
                Fault::run);
}

bool has_material_file(const TriangleSheet& sheet, const fs::path& file) {
    return !sheet.material.empty() && lower_extension(file) == ".obj";
}

void write_mesh(const TriangleSheet& sheet, const fs::path& file) {
    if (has_material_file(sheet, file))
        replace_file(material_file(file), material_text(sheet.material, file));
    replace_file(file, mesh_bytes(sheet, file));
}

}  // namespace sherd
