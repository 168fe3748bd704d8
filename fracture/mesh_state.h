// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "meshops/mesh.h"

namespace sherd {

/// Visits a mesh: its connectivity by element numbers, its points, and its properties of mesh.h,
/// face_groups.h, read_mesh.h, file_weights.h, surface_colour.h and surface_material.h. Throws
/// std::logic_error if the mesh has removed elements, which no crack leaves.
void visit_mesh(StateVisitor& visit, Mesh& mesh);

}  // namespace sherd
