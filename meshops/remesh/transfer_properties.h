// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// Gives a remeshed mesh the attributes of the surface below it, and gives its vertices their places in
/// triangles of the file. Values that differ on the two sides of a line of the surface, as at a seam, differ
/// on the two sides of the same line of the mesh. below: [V] the face of the surface below each vertex.
void transfer_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh);

}  // namespace sherd
