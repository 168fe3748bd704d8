// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "meshops/attributes.h"

namespace sherd {

/// Visits a mesh: its connectivity by element numbers, its points, and its attributes. Throws
/// std::logic_error if the mesh has elements marked as removed; cracks leave no such elements.
void visit_mesh(StateVisitor& visit, Mesh& mesh);

/// Visits the attribute lists of a look. Materials and groups that several entries share are stored once.
void visit_look(StateVisitor& visit, SurfaceLook& look);

}  // namespace sherd
