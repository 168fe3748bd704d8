// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/shell/breakable_shell.h"
#include "fracture/shell/start_exemptions.h"

namespace sherd {

/// The mesh with its vertices at their current positions.
Mesh placed_mesh(const BreakableShell& shell);

/// Finds all pairs of faces that overlap at the start, each once: first those that intersect (by exact
/// predicates) or touch, then those that are closer than 0.99 of their activation distance in SheetContact,
/// which would push them apart at the start. Both are ascending by their faces. Faces of one sheet with
/// coincident vertices, as along a seam, do not count, nor exempt pairs.
std::vector<StartOverlap> start_overlaps(const BreakableShell& shell);

}  // namespace sherd
