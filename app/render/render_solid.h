// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/render/trace/render_scene.h"
#include "fracture/record/snapshot.h"

namespace sherd {

/// Colours, stripes and pictures of a sheet.
struct SheetPaint {
    std::vector<Eigen::Vector3f> colour;  ///< [V] albedo
    Eigen::Matrix3Xf stripe = {};         ///< [3, F] RenderVertex::stripe at corners; empty: none
    /// [F] colours at corners, instead of the vertices' colours; empty: none.
    std::vector<std::array<Eigen::Vector3f, 3>> corner_colour = {};
    std::vector<FaceTexture> texture = {};   ///< [F]; empty: none
    std::vector<std::int32_t> picture = {};  ///< [F] RenderMesh::picture; empty: none
    std::vector<std::shared_ptr<const Image>> pictures = {};
};

/// Whether each edge of each face (corner i to the next one) belongs to no other face.
std::vector<std::array<bool, 3>> open_edges(std::span<const std::array<Index, 3>> faces);

/// Whether each edge of each face lies on the rim of the unfractured mesh.
std::vector<std::array<bool, 3>> rim_edges(const RestMesh& rest);

/// Sheets of a frame as bodies: the surface moved by half the thickness to both sides along the vertices'
/// normals, closed by walls along its edges. Walls that are not on the rim of the unfractured mesh are
/// broken. thickness: [F] m; origin: m, subtracted from all positions.
RenderMesh sheet_solid(const Snapshot& frame, std::span<const double> thickness, const SheetPaint& paint,
                       const Vector3d& origin);

}  // namespace sherd
