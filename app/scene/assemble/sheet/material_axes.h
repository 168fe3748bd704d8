// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/scene/material_axis.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the first material axis of each face [F] of a placed mesh, unit vectors in the faces' planes.
/// place: placement of the mesh. Where the direction is perpendicular to a face, the mesh's y axis (or z, or
/// x) replaces it, with a warning. Throws Error, naming the scene's line and key, on a texture that is
/// missing, damaged or no PNG, on a mesh without texture coordinates or axes, on a face whose texture
/// coordinates have no area, and on a face for which the texture or the mesh file gives no direction.
std::vector<Eigen::Vector3d> material_axes(const MaterialAxis& axis, const Mesh& placed,
                                           const Eigen::Isometry3d& place,
                                           std::vector<std::string>& warnings);

}  // namespace sherd
