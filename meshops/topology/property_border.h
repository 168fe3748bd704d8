// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Whether the two faces of an interior edge, given by a halfedge, have different groups, materials, or
/// texture coordinates at the edge. Returns false for edges of the boundary.
bool is_property_border(const Mesh& mesh, Halfedge h);

}  // namespace sherd
