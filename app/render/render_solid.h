// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/recording/recording.h"
#include "app/render/render_scene.h"

namespace sherd {

/// What is drawn on a sheet.
struct SheetPaint {
    std::vector<Eigen::Vector3f> colour;  ///< [V] albedo
    Eigen::Matrix3Xf stripe;              ///< [3, F] RenderVertex::stripe at corners; empty: none
};

/// Which edges of each face (corner i to the next one) no other face has.
std::vector<std::array<bool, 3>> open_edges(std::span<const std::array<Index, 3>> faces);

/// The sheets of a frame as bodies: the surface moved by half the thickness to both sides along the vertices'
/// normals, closed by walls along its edges. Walls that are no edge at rest are broken. thickness: [F] m;
/// rest_open: open_edges(header.rest_faces); origin: subtracted from all positions.
RenderMesh sheet_solid(const RecordingHeader& header, std::span<const std::array<bool, 3>> rest_open,
                       const Snapshot& frame, std::span<const double> thickness, const SheetPaint& paint,
                       const Vector3d& origin);

}  // namespace sherd
