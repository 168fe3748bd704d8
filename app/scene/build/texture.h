// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Returns the texture coordinates of the faces' corners. Throws Error if the mesh has none, or some are not
/// finite.
Mesh::Property_map<Face, FaceTexture> texture_coordinates(const Mesh& mesh);

}  // namespace sherd
