// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/shell/breakable_shell.h"
#include "fracture/shell/start_exemptions.h"

namespace sherd {

/// Returns a copy of the mesh whose points are the current positions.
Mesh placed_mesh(const BreakableShell& shell);

/// Returns all pairs of faces that overlap at the start, each pair once. First come the pairs that intersect
/// (by exact predicates) or touch, ascending by their faces; then, ascending again, the pairs whose distance
/// is less than 0.99 of their activation distance in SheetContact, which would push them apart. Faces of one
/// sheet with coincident vertices, as along a seam, are left out, and so are exempt pairs.
std::vector<StartOverlap> start_overlaps(const BreakableShell& shell);

}  // namespace sherd
