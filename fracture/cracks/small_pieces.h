// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Whether the failure of `edge`, after that of the edges `failed` [E] (1: failed), would separate a piece
/// whose area at rest is less than that of a square of side `smallest` (m). Faces are connected where an edge
/// between them has a hinge.
bool separates_small_piece(const BreakableShell& shell, Edge edge, double smallest,
                           std::span<const char> failed);

/// Makes permanently unbreakable those of `edges`, which are to fail together, whose failure would separate a
/// piece smaller than ArtDirection::smallest of its sheet. Where several of the edges together separate such
/// a piece, only the last of them is kept. Returns the number of edges kept; no piece is counted twice, since
/// the edge that holds it stays unbreakable.
Index prevent_small_pieces(BreakableShell& shell, std::span<const Edge> edges);

}  // namespace sherd
