// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Whether the faces on both sides of an inner edge are in other groups, have other materials, or have other
/// texture coordinates at it. No edge of a border is one.
bool is_property_border(const Mesh& mesh, Halfedge h);

}  // namespace sherd
