// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "meshops/face_groups.h"
#include "meshops/mesh.h"
#include "meshops/surface_colour.h"
#include "meshops/surface_material.h"

namespace sherd {

/// How a triangle of a body is lit: smoothly over its sides and along a rim that was made, flat where it
/// broke. Triangles of rims and breaks follow all others, in pairs that make quadrilaterals.
enum class Shading : std::uint8_t { smooth, rim, broken };

/// Triangles ready to be written, as exported from a recorded frame or a Mesh.
struct TriangleSheet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> group;       ///< number of each triangle's group; empty: one group
    std::vector<std::string> group_names;  ///< name of each group
    std::vector<GroupNames> named_groups;  ///< of each triangle, as in the file read (OBJ); empty: none
    std::vector<Eigen::Vector3d> axis;     ///< of each triangle, first material axis (PLY); empty: none
    std::vector<FaceTexture> texture;      ///< of each triangle; empty: none
    std::vector<FaceMaterial> material;    ///< of each triangle (OBJ); empty: none
    std::vector<double> quality;           ///< of each triangle, a scalar (PLY); empty: none
    std::vector<Shading> shading;          ///< of each triangle; empty: all smooth
    std::vector<std::array<Eigen::Vector3d, 3>> normal;  ///< of each triangle's corners (OBJ); empty: none
    std::vector<Colour> colour;                          ///< of each triangle (PLY); empty: none
    std::vector<Colour> point_colour;                    ///< of each point (PLY); empty: none
};

TriangleSheet triangle_sheet(const Mesh& mesh);

/// Adds a mesh to others, which have groups, as a group of its own. Its own groups are dropped, and how
/// triangles are shaded; texture coordinates, normals, colours, materials and named groups come from all
/// meshes that have some, spaces in these names as underscores: in OBJ a name of several words is an
/// object's.
void add_group(TriangleSheet& all, const TriangleSheet& mesh, const std::string& name);

/// Whether write_mesh() supports the file's extension: .obj, .ply or .off, in any case.
bool can_write_mesh(const std::filesystem::path& file);

/// The content of a mesh file called `file`, in the format of its extension: OBJ (an `o` line for each group,
/// or `g` and `o` lines for the named groups), binary PLY (property `fragment` for the group) or OFF (points
/// and triangles only). Vertices and triangles keep their order, except that OBJ lists the triangles group by
/// group if there are no named groups. Throws Error (Fault::run) on an unknown extension, and if the arrays
/// of the sheet do not fit together.
std::string mesh_bytes(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Whether an OBJ file of the sheet names another one, material_file(), that holds its materials.
bool has_material_file(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Writes mesh_bytes() to `file`, which gets its name only when it is complete, and its file of materials.
/// Throws Error (Fault::run) if it cannot be written.
void write_mesh(const TriangleSheet& sheet, const std::filesystem::path& file);

}  // namespace sherd
