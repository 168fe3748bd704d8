// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Plain triangles, ready to be written: what an export needs of a recorded frame or of a Mesh.
struct TriangleSheet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> group;       ///< object of each triangle; empty: one object
    std::vector<std::string> group_names;  ///< name of each object
    std::vector<FaceTexture> texture;      ///< per triangle; empty: none
    std::vector<double> quality;           ///< per triangle scalar (PLY); empty: none
};

TriangleSheet triangle_sheet(const Mesh& mesh);

/// Write `sheet` to `file`, as OBJ (an `o` for each group) or binary PLY (property `fragment` for the group),
/// by its extension (.obj, .ply). Vertices and triangles keep their order (in OBJ the triangles of a group
/// stand together, in order). The file appears under its name only when it is complete. Throws Error
/// (Fault::run) when it cannot be written.
void write_mesh(const TriangleSheet& sheet, const std::filesystem::path& file);

}  // namespace sherd
