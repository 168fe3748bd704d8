// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// The polygons of a mesh file, and where in the file each of them is.
struct PolygonSoup {
    std::filesystem::path file;
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;     ///< corners, as indices into `points`
    std::vector<std::vector<Eigen::Vector2d>> texture;  ///< texture coordinates of each corner; empty: none
    SurfaceLook look;                       ///< look of points and polygons, without texture coordinates
    std::vector<std::string> warnings;      ///< sentences on missing files and skipped content
    std::vector<std::size_t> point_line;    ///< line of each point, from 1; empty if the format has no lines
    std::vector<std::size_t> polygon_line;  ///< line of each polygon, likewise
};

/// Reads the points and polygons of an .obj, .ply, .off or .stl file, in the order of the file; points of
/// .stl are joined. Throws Error if the file is missing, unreadable, of unknown extension or damaged.
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

/// Parses the text of an OBJ file for read_polygon_soup(): `v`, `vt`, `f`, `g` and `o` lines in any letter
/// case, with negative indices, weights and continued lines, `usemtl` and `mtllib`; what else would make a
/// surface is passed over with a warning. A face belongs to the groups of the last `g` line, each word a name
/// (or to none if there are no words), and to a group named by the last `o` line. Files of materials are read
/// beside `file`. Throws Error if there are no faces, but free-form surfaces, lines or the like.
PolygonSoup parse_obj(const std::filesystem::path& file, std::string_view text);
/// Parses the content of an STL file, text or binary.
PolygonSoup parse_stl(const std::filesystem::path& file, std::string_view text);
/// Parses the content of a PLY file: the elements `vertex` and `face`, with colours of both and material axes
/// of the latter, or `tristrips` if there are no faces.
PolygonSoup parse_ply(const std::filesystem::path& file, std::string_view content);
/// The values of the property `name` of the element `vertex` of a PLY file, for read_vertex_property().
std::vector<double> parse_ply_property(const std::filesystem::path& file, std::string_view content,
                                       const std::string& name);
/// Parses the content of an OFF file: points and polygons; normals, colours and texture coordinates are
/// ignored.
PolygonSoup parse_off(const std::filesystem::path& file, std::string_view content);
/// Whether the content of a file is binary: it has a zero byte.
inline bool is_binary(std::string_view content) {
    return content.find('\0') != content.npos;
}

/// The place of a point for the start of a message: "bowl.obj:12: vertex 11", without the line if it is
/// unknown.
std::string place_of_point(const PolygonSoup& soup, std::size_t point);
/// The place of a polygon, likewise: "bowl.obj:40: face 7".
std::string place_of_polygon(const PolygonSoup& soup, std::size_t polygon);

/// Throws Error unless there are polygons, every corner is a point that exists, and the coordinates of points
/// that polygons use are finite.
void check_polygon_soup(const PolygonSoup& soup);

/// Whether a polygon of three or more corners uses each point: [P].
std::vector<bool> used_points(const PolygonSoup& soup);
/// Polygons of fewer than three corners, which bound nothing, ascending; also those without any, which stand
/// for dropped ones.
std::vector<std::size_t> polygons_of_few_corners(const PolygonSoup& soup);

/// Replaces, in the polygons, points at exactly the same place by the first of them. Returns the number of
/// points that are no longer used for this reason.
std::size_t join_duplicate_points(PolygonSoup& soup);
/// Replaces each point on the boundary, on sides of one polygon, by the nearest earlier one that stays and is
/// within `distance`. Returns the number of points that are no longer used for this reason. Throws Error
/// unless twice the distance is below the mean length of these sides.
std::size_t join_near_points(PolygonSoup& soup, double distance);
/// Whether there is more than one polygon and no two of them have a corner in common, as in formats without
/// shared points.
bool shares_no_point(const PolygonSoup& soup);

}  // namespace sherd
