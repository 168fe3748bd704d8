// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/face_groups.h"
#include "meshops/mesh.h"

namespace sherd {

/// Polygons as a mesh file gives them, and where in the file each of them stands.
struct PolygonSoup {
    std::filesystem::path file;
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;  ///< corners, as indices into `points`
    std::vector<std::vector<Eigen::Vector2d>>
        texture;                            ///< of each corner; a polygon without: empty; none at all: empty
    std::vector<Eigen::Vector3d> axis;      ///< of each polygon, its material axis; none: empty
    std::vector<GroupNames> groups;         ///< of each polygon; a format without groups: empty
    std::vector<std::size_t> point_line;    ///< 1-based; empty where a format has no lines
    std::vector<std::size_t> polygon_line;  ///< likewise
};

/// Reads the points and polygons of an .obj, .ply, .off or .stl file, in the order of the file; points of
/// .stl are joined. Throws Error when the file is missing, unreadable, of unknown extension or damaged.
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

/// The part of read_polygon_soup that reads the text of an OBJ file: `v`, `vt`, `f`, `g` and `o` lines (with
/// negative indices and continued lines); what else the file holds is passed over. A face is in the groups of
/// the last `g` line (a name a word; none: in no group) and in one with the name of the last `o` line.
PolygonSoup parse_obj(const std::filesystem::path& file, std::string_view text);
/// Likewise the content of an STL file, text or binary.
PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text);
/// Likewise of a PLY file: elements `vertex` and `face`, of which the material axes, too.
PolygonSoup parse_ply(const std::filesystem::path& file, std::string_view content);
/// Likewise of an OFF file: points and polygons; normals, colours and texture coordinates are passed over.
PolygonSoup parse_off(const std::filesystem::path& file, std::string_view content);
/// Whether the content of a file is not text.
inline bool is_binary(std::string_view content) {
    return content.find('\0') != content.npos;
}

/// "bowl.obj:12: vertex 11", or without the line where it is not known: the start of a message.
std::string place_of_point(const PolygonSoup& soup, std::size_t point);
/// "bowl.obj:40: face 7", likewise.
std::string place_of_polygon(const PolygonSoup& soup, std::size_t polygon);

/// Throws Error unless there are polygons, all coordinates are finite, and every polygon has at least three
/// corners, all of them points that exist.
void check_polygon_soup(const PolygonSoup& soup);

/// Lets the polygons use only the first of all points at exactly the same place; returns how many points are
/// thereby left unused.
std::size_t join_duplicate_points(PolygonSoup& soup);

}  // namespace sherd
