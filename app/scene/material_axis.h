// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/axis_texture.h"
#include "meshops/mesh.h"

namespace sherd {

/// A direction in the mesh's own frame, projected to the surface and turned counterclockwise about the face's
/// normal.
struct AxisDirection {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
    double degrees = 0;
};

/// The mesh file's own: property::axis, projected to the surface.
struct AxisField {};

/// Where a sheet's first material axis comes from. Its directions are those of the mesh before it is placed.
struct MaterialAxis {
    std::variant<AxisDirection, AxisTexture, AxisField> kind;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// The first material axis of each face [F], unit vectors in the faces' planes, on the mesh as it is placed.
/// Where the direction is perpendicular to a face, the mesh's y axis (or z, or x) takes its place, which a
/// warning tells. Throws Error naming the scene's line and key on: a texture that is missing, damaged or no
/// PNG, a mesh without texture coordinates or axes, a face whose coordinates have no area, or where texture
/// or field have no direction.
std::vector<Eigen::Vector3d> material_axes(const MaterialAxis& axis, const Mesh& placed,
                                           const Eigen::Isometry3d& place,
                                           std::vector<std::string>& warnings);

}  // namespace sherd
