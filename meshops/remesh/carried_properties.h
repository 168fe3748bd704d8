// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// Gives a remeshed mesh the texture coordinates, groups, materials, colours and axes that the surface has
/// below it, and the places of its vertices in the file. What changes along a line there, as at a seam,
/// changes along it here. below: [V] a face of the surface for each vertex.
void carry_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh);

}  // namespace sherd
