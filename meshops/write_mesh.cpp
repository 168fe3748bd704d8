// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/write_mesh.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/material_library.h"
#include "meshops/number_text.h"
#include "meshops/obj_text.h"
#include "meshops/raw_bytes.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Number of colour components in a PLY file: 4, with opacity, only if something is not opaque, otherwise 3.
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

/// Appends the values of `count` elements to those of `before` ones; `otherwise` fills in for either without
/// any.
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
