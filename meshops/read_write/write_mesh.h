// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// Shading of a body's triangles: smooth over the two sides of a sheet and along its original rim, flat on
/// crack faces. Triangles of the rim and of crack faces follow all others, in pairs that form quadrilaterals.
enum class Shading : std::uint8_t { smooth, rim, broken };

/// Triangles ready to be written, as exported from a recorded frame or a Mesh.
struct TriangleSheet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> group;       ///< number of each triangle's group; empty: one group
    std::vector<std::string> group_names;  ///< name of each group
    SurfaceLook look;                      ///< look of points and triangles
    std::vector<double> quality;           ///< a scalar for each triangle (PLY); empty: none
    std::vector<Shading> shading;          ///< shading of each triangle; empty: all smooth
    std::vector<std::array<Eigen::Vector3d, 3>> normal;  ///< normals at triangle corners (OBJ); empty: none
};

TriangleSheet triangle_sheet(const Mesh& mesh);

/// Appends a mesh to others, which have groups, as a group of its own. The mesh's own numbered groups and the
/// shading of all meshes are dropped; normals and what files gave (SurfaceLook) come from all meshes that
/// have some. Spaces in names of groups become underscores: in OBJ a name of several
/// words belongs to an object.
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
