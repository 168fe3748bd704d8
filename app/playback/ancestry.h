// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// Where the mesh of a later frame was in that of an earlier one. Faces keep their corners, so they know
/// which vertices cracks have split. What has been born inside an edge or a face since then, or is a part of
/// a face that has been split, lies flat in the face that it is a part of.
struct Ancestry {
    std::vector<Index> faces;                    ///< [F] the earlier face that each was, or was a part of
    std::vector<std::array<Index, 3>> vertices;  ///< [V] earlier vertices between which each was, and
    std::vector<std::array<double, 3>> weights;  ///< [V] their shares, which sum to 1

    /// Values of the earlier vertices [3, ...] at the later ones [3, V].
    Positions carried(const Positions& earlier) const;
};

/// Throws Error (input) when the frames are not those of one run, in this order.
Ancestry ancestry(const Snapshot& earlier, const Snapshot& later);

}  // namespace sherd
