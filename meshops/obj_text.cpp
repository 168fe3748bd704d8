// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/obj_text.h"

#include <algorithm>
#include <array>
#include <map>

#include "meshops/error.h"
#include "meshops/material_library.h"
#include "meshops/number_text.h"
#include "meshops/obj_name.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// The state that is carried from one object of an OBJ file to the next: counts, and the current groups and
/// material.
struct ObjState {
    std::size_t points = 0, texture = 0, normals = 0;
    GroupNames names;
    FaceMaterial material;
};

/// Appends the lines that put the following faces into exactly these groups. Only an object's name may have
/// several words; `has_objects` tells whether any of the names has.
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

/// Appends the values of triangle corners, each different value once, on a line of its own. Returns their
/// numbers in the file. count: number of values in the file so far.
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

/// Appends the lines with the groups and the material of a triangle, if they differ from the previous ones.
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

/// The name of the file of materials. Throws Error if it has a line break.
std::string library_name(const fs::path& file) {
    std::string name = material_file(file).filename().string();
    if (name.find_first_of("\r\n") == name.npos) return name;
    throw Error(file.string() + ": the name has a line break, which an OBJ file cannot hold; give another",
                Fault::run);
}

}  // namespace

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

}  // namespace sherd
