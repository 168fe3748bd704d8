// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the texture coordinates of the faces' corners. Throws Error if the mesh has none, or some are not
/// finite.
Mesh::Property_map<Face, FaceTexture> texture_coordinates(const Mesh& mesh);

/// vertex_values() returns the values of a map at the vertices of a sheet [V], edge_values() at the middles
/// of its edges [E]. placed: the sheet's mesh where the scene places it. Along a seam of a texture the value
/// is the mean over the adjacent faces. A property of vertices has, in the middle of an edge, the mean of the
/// edge's ends. Throws Error on a file that is missing, damaged or of another kind, on a mesh without texture
/// coordinates or without the property, and on a grid that is not in the file. Adds a warning with the number
/// of places outside a grid's active region.
std::vector<double> vertex_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                  std::vector<std::string>& warnings);
std::vector<double> edge_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings);

/// Returns the name of a source for errors: the name of its file or of the property.
std::string source_text(const MapSource& source);

/// Returns the transformation from the placed mesh back to the frame and the unit of its file, in which grids
/// are given.
Eigen::Affine3d to_file(const SheetSpec& sheet);

/// Returns the middle of an edge, m.
Eigen::Vector3d edge_middle(const Mesh& mesh, Edge edge);

}  // namespace sherd
