// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// The polygons of a mesh file, and the place of each in the file.
struct PolygonSoup {
    std::filesystem::path file;
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;     ///< corners, as indices into `points`
    std::vector<std::vector<Eigen::Vector2d>> texture;  ///< coordinates of polygons' corners; empty: none
    SurfaceLook look;                     ///< attributes of points and polygons, without texture coordinates
    std::vector<std::string> warnings;    ///< sentences on missing files and skipped content
    std::vector<std::size_t> point_line;  ///< line of each point, from 1; empty if the format has no lines
    std::vector<std::size_t> polygon_line;  ///< line of each polygon, as in `point_line`
};

/// Reads the points and polygons of an .obj, .ply, .off or .stl file, in the order of the file. Points of
/// .stl files at the same place are joined. Throws Error if the file is missing, unreadable, of unknown
/// extension or damaged.
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

/// Parses the text of an OBJ file for read_polygon_soup(): statements `v`, `vt`, `f`, `g`, `o`, `usemtl` and
/// `mtllib` in any letter case, with negative indices, weights and continued lines. Statements about display
/// are ignored; all others are skipped with a warning. A face belongs to the groups of the last `g` line,
/// each word of which is a name (no words: no groups), and to a group with the name of the last `o` line.
/// Files of materials are looked for in the folder of `file`. Throws Error if there are no faces, but skipped
/// statements such as free-form surfaces or lines.
PolygonSoup parse_obj(const std::filesystem::path& file, std::string_view text);
/// Parses the content of an STL file, text or binary.
PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text);
/// Parses the content of a PLY file: the elements `vertex` and `face` with their colours and their attributes
/// that are numbers, such as material axes of faces; or `tristrips` if there are no faces.
PolygonSoup parse_ply(const std::filesystem::path& file, std::string_view content);
/// Returns the values of the property `name` of the element `vertex` of a PLY file, for
/// read_vertex_property().
std::vector<double> parse_ply_property(const std::filesystem::path& file, std::string_view content,
                                       const std::string& name);
/// Parses the content of an OFF file: points and polygons; normals, colours and texture coordinates are
/// ignored.
PolygonSoup parse_off(const std::filesystem::path& file, std::string_view content);
/// Whether the content of a file is binary: it has a zero byte.
inline bool is_binary(std::string_view content) {
    return content.find('\0') != content.npos;
}

/// Returns the place of a point for the start of a message: "bowl.obj:12: vertex 11", without the line if it
/// is unknown.
std::string place_of_point(const PolygonSoup& soup, std::size_t point);
/// Returns the place of a polygon for the start of a message: "bowl.obj:40: face 7".
std::string place_of_polygon(const PolygonSoup& soup, std::size_t polygon);

/// Throws Error unless there are polygons, every corner is a point that exists, and the coordinates of points
/// that polygons use are finite.
void check_polygon_soup(const PolygonSoup& soup);

/// Returns, for each point, [P], whether a polygon of three or more corners uses it.
std::vector<bool> used_points(const PolygonSoup& soup);
/// Returns the polygons of fewer than three corners, ascending. Polygons without corners, which stand for
/// dropped polygons, are among them.
std::vector<std::size_t> polygons_of_few_corners(const PolygonSoup& soup);

/// Replaces, in the polygons, points at exactly the same place by the first of these points. Returns the
/// number of points that are no longer used for this reason.
std::size_t join_duplicate_points(PolygonSoup& soup);
/// Replaces each point on the boundary, whose sides belong to one polygon only, by the nearest earlier
/// boundary point within `distance` that is not itself replaced. Returns the number of points that are no
/// longer used for this reason. Throws Error unless twice `distance` is below the mean length of the sides on
/// the boundary.
std::size_t join_near_points(PolygonSoup& soup, double distance);
/// Whether there are several polygons, and no two of them have a corner in common, as in formats without
/// shared points.
bool shares_no_point(const PolygonSoup& soup);

}  // namespace sherd
