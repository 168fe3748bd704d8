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

/// The values of a map at the vertices of a sheet [V], or at the middles of its edges [E]. placed: the
/// sheet's mesh where the scene places it. Along a seam of a texture the value is the mean over the faces
/// there; a property has the mean of both ends in the middle of an edge. Throws Error on a file that is
/// missing, damaged or of another kind, on a mesh without texture coordinates or without the property, and on
/// a grid that is not in the file. A warning gives the number of places outside a grid's active region.
std::vector<double> vertex_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                  std::vector<std::string>& warnings);
std::vector<double> edge_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings);

/// Name of the source for errors: the file's name, or the property.
std::string source_text(const MapSource& source);

/// The map from the placed mesh back to the frame of its file, in which grids are.
Eigen::Affine3d to_file(const SheetSpec& sheet);

/// The middle of an edge, m.
Eigen::Vector3d edge_middle(const Mesh& mesh, Edge edge);

}  // namespace sherd
