// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "meshops/face_groups.h"
#include "meshops/mesh.h"

namespace sherd {

/// Red, green and blue.
using Colour = std::array<std::uint8_t, 3>;

/// Plain triangles, ready to be written: what an export needs of a recorded frame or of a Mesh.
struct TriangleSheet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> group;       ///< object of each triangle; empty: one object
    std::vector<std::string> group_names;  ///< name of each object
    std::vector<GroupNames> named_groups;  ///< per triangle, as in the file read (OBJ); empty: none
    std::vector<Eigen::Vector3d> axis;     ///< per triangle, first material axis (PLY); empty: none
    std::vector<FaceTexture> texture;      ///< per triangle; empty: none
    std::vector<double> quality;           ///< per triangle scalar (PLY); empty: none
    std::vector<Colour> colour;            ///< per triangle (PLY); empty: none
    std::vector<Colour> point_colour;      ///< per point (PLY); empty: none
};

TriangleSheet triangle_sheet(const Mesh& mesh);

/// Whether write_mesh() knows the file's extension: .obj, .ply or .off, in capitals or not.
bool can_write_mesh(const std::filesystem::path& file);

/// The content of a mesh file called `file`, by its extension OBJ (an `o` for each group, or `g` and `o`
/// lines for the named groups), binary PLY (property `fragment` for the group) or OFF (points and triangles
/// alone). Vertices and triangles keep their order (in OBJ the triangles of a group stand together, in order;
/// those of named groups stay where they are). Throws Error (Fault::run) on an unknown extension and a sheet
/// that does not fit together.
std::string mesh_bytes(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Writes mesh_bytes() to `file`, which appears under its name only when it is complete. Throws Error
/// (Fault::run) when it cannot be written.
void write_mesh(const TriangleSheet& sheet, const std::filesystem::path& file);

}  // namespace sherd
