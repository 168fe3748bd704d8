// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// Shading of the triangles of a body: smooth over the two sides of a sheet; smooth along its original rim;
/// flat on crack faces (`broken`). Triangles of the rim and of crack faces follow all others, in pairs that
/// form quadrilaterals.
enum class Shading : std::uint8_t { smooth, rim, broken };

/// Triangles ready to be written, as exported from a recorded frame or a Mesh.
struct TriangleSheet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> group;       ///< number of each triangle's group; empty: one group
    std::vector<std::string> group_names;  ///< name of each group
    SurfaceLook look;                      ///< attributes of points and triangles
    std::vector<double> quality;           ///< a number for each triangle, only for PLY; empty: none
    std::vector<Shading> shading;          ///< shading of each triangle; empty: all smooth
    std::vector<std::array<Eigen::Vector3d, 3>> normal;  ///< normals at corners, only for OBJ; empty: none
};

TriangleSheet triangle_sheet(const Mesh& mesh);

/// Appends `mesh` to `all`, whose triangles all have groups, as a new group `name`. The numbered groups that
/// `mesh` had itself are dropped, and the shading of both. If one of the two has normals, or an attribute
/// (SurfaceLook), the result has them, with a default for the other one. Spaces in names of groups in `look`
/// become underscores: in OBJ a name of several words belongs to an object.
void add_group(TriangleSheet& all, const TriangleSheet& mesh, const std::string& name);

/// Whether write_mesh() supports the extension of the file: .obj, .ply or .off, in upper or lower case.
bool can_write_mesh(const std::filesystem::path& file);

/// Returns the content of a mesh file called `file`, in the format of its extension: OBJ (an `o` line for
/// each numbered group, `g` and `o` lines for the groups in `look`), binary PLY (property `fragment` for the
/// numbered group) or OFF (points and triangles only). Vertices and triangles keep their order, except that
/// OBJ lists them by numbered group if there are such groups. Throws Error (Fault::run) on an unknown
/// extension, and if the arrays of the sheet do not fit together.
std::string mesh_bytes(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Whether write_mesh() writes the materials of the sheet to material_file(), which `file`, an OBJ file,
/// names.
bool has_material_file(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Writes mesh_bytes() to `file` and, if has_material_file() is true, the materials to material_file(). A
/// file gets its name only when it is complete. Throws Error (Fault::run) if a file cannot be written.
void write_mesh(const TriangleSheet& sheet, const std::filesystem::path& file);

}  // namespace sherd
