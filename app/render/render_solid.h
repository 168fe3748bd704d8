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
    std::vector<Eigen::Vector3f> colour;  ///< [V] albedo of each vertex
    Eigen::Matrix3Xf stripe = {};         ///< [3, F] RenderVertex::stripe at corners of faces; empty: none
    /// [F] colours at the corners of each face, which replace the vertices' colours; empty: none.
    std::vector<std::array<Eigen::Vector3f, 3>> corner_colour = {};
    std::vector<FaceTexture> texture = {};   ///< [F] coordinates at corners; empty: none
    std::vector<std::int32_t> picture = {};  ///< [F] as RenderMesh::picture; empty: none
    std::vector<std::shared_ptr<const Image>> pictures = {};
};

/// Returns for each face whether its edges, from corner i to the next one, belong to no other face.
std::vector<std::array<bool, 3>> open_edges(std::span<const std::array<Index, 3>> faces);

/// Returns for each face whether its edges, from corner i to the next one, lie on the rim of the unfractured
/// mesh.
std::vector<std::array<bool, 3>> rim_edges(const RestMesh& rest);

/// Returns the sheets of a frame as solid bodies: the surface is moved by half the thickness to both sides
/// along the vertices' normals, and walls along its edges close it. Walls that are not on the rim of the
/// unfractured mesh are broken. thickness: [F] m; origin: m, is subtracted from all positions.
RenderMesh sheet_solid(const Snapshot& frame, std::span<const double> thickness, const SheetPaint& paint,
                       const Vector3d& origin);

}  // namespace sherd
