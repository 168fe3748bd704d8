// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/write_mesh.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/number_text.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_write/material_library.h"
#include "meshops/read_write/obj_name.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// State that is carried from one object of an OBJ file to the next: numbers of points, texture points and
/// normals so far, and the current groups and material.
struct ObjState {
    std::size_t points = 0, texture = 0, normals = 0;
    GroupNames names;
    FaceMaterial material;
};

/// Appends the lines that put the following faces into exactly the groups `names`. A name of several words
/// goes into an `o` line, since a `g` line has names of one word. has_objects: whether any name in the file
/// has several words.
void append_named_groups(std::string& text, const GroupNames& names, bool has_objects) {
    std::string group = "g", object = "o";
    if (names)
        for (const std::string& name : *names)
            append_all(name.find(' ') == name.npos ? group : object, " ", writable_name(name).c_str());
    append_all(text, group.c_str(), "\n");
    if (has_objects) append_all(text, object.c_str(), "\n");
}

bool has_objects(const TriangleSheet& sheet) {
    const auto is_long = [](const std::string& name) { return name.find(' ') != name.npos; };
    return std::ranges::any_of(sheet.look.groups, [&](const GroupNames& names) {
        return names && std::ranges::any_of(*names, is_long);
    });
}

/// Appends a line with `keyword` for each different value at the corners of `triangles`. Returns the numbers
/// in the file of the values at the corners of each of these triangles. values: three for each triangle of
/// the sheet, or empty. count: number of lines with `keyword` in the file so far.
template <class Values>
std::vector<std::array<std::size_t, 3>> append_corners(std::string& text, const char* keyword,
                                                       const Values& values,
                                                       const std::vector<std::size_t>& triangles,
                                                       std::size_t& count) {
    std::vector<std::array<std::size_t, 3>> numbers(values.empty() ? 0 : triangles.size());
    std::map<std::vector<double>, std::size_t> known;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const auto& value = values[triangles[i]][corner];
            const auto [entry, is_new] = known.try_emplace({value.begin(), value.end()}, count + 1);
            numbers[i][corner] = entry->second;
            if (!is_new) continue;
            ++count;
            append(text, keyword);
            for (const double coordinate : value) append_all(text, " ", coordinate);
            text += '\n';
        }
    return numbers;
}

/// Appends the lines with the groups and the material of a triangle, if they differ from those in `state`.
/// objects: whether any name of a group in the file has several words.
void append_state(std::string& text, const TriangleSheet& sheet, std::size_t triangle, bool objects,
                  ObjState& state) {
    if (!sheet.look.groups.empty() && sheet.look.groups[triangle] != state.names) {
        state.names = sheet.look.groups[triangle];
        append_named_groups(text, state.names, objects);
    }
    if (!sheet.look.material.empty() && !is_same(sheet.look.material[triangle], state.material)) {
        state.material = sheet.look.material[triangle];
        append_all(text, "usemtl ", writable_name(material_name(state.material)).c_str(), "\n");
    }
}

/// Rounds normals to six decimals: more would make no visible difference.
std::vector<std::array<Eigen::Vector3d, 3>> rounded(std::vector<std::array<Eigen::Vector3d, 3>> normals) {
    for (auto& corners : normals)
        for (Eigen::Vector3d& normal : corners) normal = (normal * 1e6).array().round() / 1e6;
    return normals;
}

/// Appends one complete object: its points, texture points, normals and faces.
void append_object(std::string& text, const TriangleSheet& sheet, const std::vector<std::size_t>& triangles,
                   const std::vector<std::size_t>& points, ObjState& state) {
    std::vector<std::size_t> point_number(sheet.points.size());
    for (const std::size_t i : points) {
        point_number[i] = ++state.points;
        const auto& p = sheet.points[i];
        append_all(text, "v ", p.x(), " ", p.y(), " ", p.z(), "\n");
    }
    const auto texture = append_corners(text, "vt", sheet.look.texture, triangles, state.texture);
    const auto normal = append_corners(text, "vn", rounded(sheet.normal), triangles, state.normals);
    const bool objects = has_objects(sheet);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        append_state(text, sheet, triangles[i], objects, state);
        text += 'f';
        for (int corner = 0; corner < 3; ++corner) {
            append_all(text, " ", point_number[sheet.triangles[triangles[i]][corner]]);
            if (!texture.empty() || !normal.empty()) text += '/';
            if (!texture.empty()) append(text, texture[i][corner]);
            if (!normal.empty()) append_all(text, "/", normal[i][corner]);
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

/// Returns the name of the .mtl file of an OBJ file. Throws Error if the name has a line break.
std::string library_name(const fs::path& file) {
    std::string name = material_file(file).filename().string();
    if (name.find_first_of("\r\n") == name.npos) return name;
    throw Error(file.string() + ": the name has a line break, which an OBJ file cannot hold; give another",
                Fault::run);
}

/// Returns the content of the OBJ file `file`, for mesh_bytes().
std::string obj_text(const TriangleSheet& sheet, const fs::path& file) {
    std::string text;
    if (!sheet.look.material.empty()) append_all(text, "mtllib ", library_name(file).c_str(), "\n");
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
        append_all(text, "o ", writable_name(sheet.group_names[group]).c_str(), "\n");
        append_object(text, sheet, triangles[group], points_of(sheet, triangles[group]), state);
    }
    return text;
}

/// Number of colour components in a PLY file: 4, with opacity, if a colour is not opaque; otherwise 3.
std::size_t colour_parts(const TriangleSheet& sheet) {
    const auto is_clear = [](const Colour& colour) { return colour[3] < 255; };
    return std::ranges::any_of(sheet.look.face_colour, is_clear) ||
                   std::ranges::any_of(sheet.look.vertex_colour, is_clear)
               ? 4
               : 3;
}

std::string colour_properties(const TriangleSheet& sheet) {
    return std::string("property uchar red\nproperty uchar green\nproperty uchar blue\n") +
           (colour_parts(sheet) == 4 ? "property uchar alpha\n" : "");
}

template <class Element>
std::string number_properties(const TriangleSheet& sheet) {
    std::string text;
    visit_numbers<Element>([&](const auto& attribute) {
        if (!(sheet.look.*attribute.list).empty())
            for (const std::string& name : ply_names(attribute)) text += "property double " + name + "\n";
    });
    return text;
}

template <class Element>
void append_numbers(std::string& bytes, const TriangleSheet& sheet, std::size_t i) {
    visit_numbers<Element>([&](const auto& attribute) {
        const auto& list = sheet.look.*attribute.list;
        if (list.empty()) return;
        auto value = list[i];
        for (const double number : numbers_of(value)) append_little_endian(bytes, number);
    });
}

std::string ply_header(const TriangleSheet& sheet) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    append_all(text, sheet.points.size(), "\nproperty double x\nproperty double y\nproperty double z\n");
    if (!sheet.look.vertex_colour.empty()) text += colour_properties(sheet);
    text += number_properties<Vertex>(sheet);
    append_all(text, "element face ", sheet.triangles.size(), "\nproperty list uchar int vertex_indices\n");
    if (!sheet.look.face_colour.empty()) text += colour_properties(sheet);
    if (!sheet.group.empty()) text += "property int fragment\n";
    if (!sheet.quality.empty()) text += "property double quality\n";
    if (!sheet.look.texture.empty()) text += "property list uchar float texcoord\n";
    return text + number_properties<Face>(sheet) + "end_header\n";
}

void append_texture(std::string& bytes, const FaceTexture& texture) {
    append_little_endian(bytes, std::uint8_t{6});
    for (const auto& uv : texture)
        for (const double coordinate : uv) append_little_endian(bytes, static_cast<float>(coordinate));
}

std::string ply_bytes(const TriangleSheet& sheet) {
    std::string bytes = ply_header(sheet);
    const std::size_t parts = colour_parts(sheet);
    const auto append_colour = [&](const Colour& colour) {
        for (std::size_t i = 0; i < parts; ++i) append_little_endian(bytes, colour[i]);
    };
    for (std::size_t i = 0; i < sheet.points.size(); ++i) {
        for (const double coordinate : sheet.points[i]) append_little_endian(bytes, coordinate);
        if (!sheet.look.vertex_colour.empty()) append_colour(sheet.look.vertex_colour[i]);
        append_numbers<Vertex>(bytes, sheet, i);
    }
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        append_little_endian(bytes, std::uint8_t{3});
        for (const std::int32_t point : sheet.triangles[t]) append_little_endian(bytes, point);
        if (!sheet.look.face_colour.empty()) append_colour(sheet.look.face_colour[t]);
        if (!sheet.group.empty()) append_little_endian(bytes, sheet.group[t]);
        if (!sheet.quality.empty()) append_little_endian(bytes, sheet.quality[t]);
        if (!sheet.look.texture.empty()) append_texture(bytes, sheet.look.texture[t]);
        append_numbers<Face>(bytes, sheet, t);
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
    const std::size_t points = sheet.points.size(), triangles = sheet.triangles.size();
    const auto fit = [](const auto& values, std::size_t count) {
        return values.empty() || values.size() == count;
    };
    require(fit(sheet.group, triangles) && fit(sheet.quality, triangles) && fit(sheet.normal, triangles) &&
                fit(sheet.shading, triangles),
            "group, normal, quality and shading need one value per triangle");
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        require(fit(sheet.look.*attribute.list, points), "an attribute needs one value per point");
    });
    visit_attributes_of<Face>([&](const auto& attribute) {
        require(fit(sheet.look.*attribute.list, triangles), "an attribute needs one value per triangle");
    });
    for (const auto& triangle : sheet.triangles) {
        for (const std::int32_t point : triangle) {
            require(point >= 0 && static_cast<std::size_t>(point) < sheet.points.size(),
                    "a triangle names a point that does not exist");
        }
    }
    for (const std::int32_t group : sheet.group) {
        require(group >= 0 && static_cast<std::size_t>(group) < sheet.group_names.size(),
                "a triangle names a group that does not exist");
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

/// Appends `values`, of `count` elements, to `all`, the values of `before` elements. If only one of the two
/// lists has values, the elements of the other get `otherwise`.
template <class Value>
void append_values(std::vector<Value>& all, const std::vector<Value>& values, std::size_t before,
                   std::size_t count, const Value& otherwise) {
    if (all.empty() && values.empty()) return;
    all.resize(before, otherwise);
    all.insert(all.end(), values.begin(), values.end());
    all.resize(before + count, otherwise);
}

}  // namespace

TriangleSheet triangle_sheet(const Mesh& mesh) {
    TriangleSheet sheet;
    // A mesh with removed elements has gaps in its numbers, so vertices are numbered again.
    std::vector<std::int32_t> number(mesh.num_vertices());
    for (const Vertex v : mesh.vertices()) {
        number[v.idx()] = static_cast<std::int32_t>(sheet.points.size());
        const Point& p = mesh.point(v);
        sheet.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const Face face : mesh.faces()) {
        auto& triangle = sheet.triangles.emplace_back();
        auto corner = triangle.begin();
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) *corner++ = number[v.idx()];
    }
    sheet.look = surface_look(mesh, number, sheet.points.size());
    return sheet;
}

void add_group(TriangleSheet& all, const TriangleSheet& mesh, const std::string& name) {
    const auto first = static_cast<std::int32_t>(all.points.size());
    const std::size_t before = all.triangles.size(), count = mesh.triangles.size();
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
    all.group.resize(before + count, static_cast<std::int32_t>(all.group_names.size()));
    all.group_names.push_back(name);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    append_values(all.normal, mesh.normal, before, count, {up, up, up});
    all.shading.clear();
    const auto join = [&](const auto& attribute, std::size_t earlier, std::size_t added) {
        append_values(all.look.*attribute.list, mesh.look.*attribute.list, earlier, added,
                      attribute.missing());
    };
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        join(attribute, all.points.size() - mesh.points.size(), mesh.points.size());
    });
    visit_attributes_of<Face>([&](const auto& attribute) { join(attribute, before, count); });
    for (std::size_t t = 0; t < mesh.look.groups.size(); ++t)
        all.look.groups[before + t] = one_word_names(mesh.look.groups[t]);
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
    return !sheet.look.material.empty() && lower_extension(file) == ".obj";
}

void write_mesh(const TriangleSheet& sheet, const fs::path& file) {
    if (has_material_file(sheet, file))
        replace_file(material_file(file), material_text(sheet.look.material, file));
    replace_file(file, mesh_bytes(sheet, file));
}

}  // namespace sherd
