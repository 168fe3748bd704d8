// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

namespace property {
inline constexpr const char* axis =
    "f:axis";  ///< Eigen::Vector3d, first material axis of each face, of any length
}  // namespace property

struct ReadMeshOptions {
    bool join_duplicate_points = false;  ///< join points at exactly the same place to one vertex
    bool repair = false;  ///< drop zero-area and repeated triangles, separate faces at non-manifold edges
    /// What the user can write to request a repair, for messages; empty if that is impossible.
    std::string_view repair_advice = "`repair = true` on the mesh";
};

/// Reads a triangle mesh from an .obj, .ply, .off or .stl file, text or binary if the format has both. Points
/// of .stl are always joined, since the format repeats them for every triangle.
/// Polygons are triangulated. Faces keep the order of the file (a polygon's triangles follow each other) and
/// the order of their corners; where inconsistent orientation is repaired, the first corner stays the first.
/// OBJ texture coordinates become property::texture, the face properties axis_x, axis_y, axis_z of PLY
/// property::axis, OBJ groups and objects property::groups (face_groups.h); every mesh gets
/// property::file_vertex. Fans of faces that meet in a single point get a point each.
/// `warnings` gets a sentence, starting with the file's name, for each change: unreferenced vertices dropped,
/// points joined or doubled, faces turned over, and what `repair` did. Throws Error naming the file (and
/// line, vertex or face, numbered from 0) if the file is missing, unreadable, damaged or of unknown
/// extension, on no faces, NaN or infinite coordinates, an index out of range, a polygon that crosses itself,
/// a surface with only one side and, unless `repair` is set, a zero-area or repeated triangle or a
/// non-manifold edge.
Mesh read_mesh(const std::filesystem::path& file, const ReadMeshOptions& options,
               std::vector<std::string>& warnings);

}  // namespace sherd
