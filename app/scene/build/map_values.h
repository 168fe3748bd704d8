// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// The values of a map at the vertices of a sheet [V], or at the middles of its edges [E]: `placed` is its
/// mesh where the scene places it. Along a seam of a texture they are the mean of what the faces there see; a
/// property has in the middle of an edge the mean of both ends. Throws Error on a file that is missing,
/// damaged or of another kind, on a mesh without texture coordinates or without the property, and on a grid
/// that the file does not hold. A warning says how many places lie outside a grid's active region.
std::vector<double> vertex_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                  std::vector<std::string>& warnings);
std::vector<double> edge_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings);

/// The source as an error names it: the file's name, or the property.
std::string source_words(const MapSource& source);

/// From the placed mesh back to the frame of its file, in which grids are.
Eigen::Affine3d to_file(const SheetSpec& sheet);

/// The middle of an edge, m.
Eigen::Vector3d edge_middle(const Mesh& mesh, Edge edge);

}  // namespace sherd
