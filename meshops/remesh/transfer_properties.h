// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// Gives a remeshed mesh the attributes of the surface below it, and the places of its vertices in triangles
/// of the file. Values that change along a line of the surface, as at a seam, change along the same line of
/// the mesh. below: [V] a face of the surface for each vertex.
void transfer_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh);

}  // namespace sherd
