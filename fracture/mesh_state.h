// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "meshops/mesh.h"

namespace sherd {

/// Visits a mesh: how its elements hang together, by their numbers, its points and what it has of the
/// properties of mesh.h, face_groups.h, read_mesh.h, file_weights.h, surface_colour.h and surface_material.h.
/// Throws std::logic_error for a mesh with removed elements, which a crack never leaves.
void visit_mesh(StateVisitor& visit, Mesh& mesh);

}  // namespace sherd
