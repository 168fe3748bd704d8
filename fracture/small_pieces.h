// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_shell.h"

namespace sherd {

/// Whether the failure of `edge`, after that of the edges `gone` [E] (1: gone), would separate a piece whose
/// area at rest is less than that of a square of side `smallest` (m). Faces hang together where an edge
/// between them has a hinge.
bool separates_small_piece(const BreakableShell& shell, Edge edge, double smallest,
                           std::span<const char> gone);

/// Makes those of `edges`, which would fail together, unbreakable for good whose failure would separate a
/// piece that is smaller than ArtDirection::smallest of its sheet. Returns how many: an edge that such a
/// piece hangs by stays the only one, so that none is counted twice. Of edges that do so together only the
/// later ones are kept.
Index keep_small_pieces_on(BreakableShell& shell, std::span<const Edge> edges);

}  // namespace sherd
