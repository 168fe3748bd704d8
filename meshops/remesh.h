// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Remeshes isotropically to `edge_length` (m): new vertices stay on the input surface, boundaries and edges
/// sharper than `feature_degrees` keep their shape. Texture coordinates are lost. Throws Error if edge_length
/// is not positive.
Mesh remesh(const Mesh& mesh, double edge_length, double feature_degrees = 40);

}  // namespace sherd
