// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Whether the failure of `edge` would separate a piece whose area at rest is less than the area of a square
/// of side `smallest` (m). Faces are connected if the edge between them has a hinge and is not marked in
/// `failed`. failed: [E] 1 for edges that fail before `edge`.
bool separates_small_piece(const BreakableShell& shell, Edge edge, double smallest,
                           std::span<const char> failed);

/// Checks `edges`, which are to fail together. If the failure of an edge would separate a piece smaller than
/// ArtDirection::smallest of its sheet, the edge becomes unbreakable, permanently. Where several of the edges
/// together separate such a piece, only the last of them becomes unbreakable. Returns the number of edges
/// that have become unbreakable. No piece is counted twice, since the edge that holds it stays unbreakable.
Index prevent_small_pieces(BreakableShell& shell, std::span<const Edge> edges);

}  // namespace sherd
