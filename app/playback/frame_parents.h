// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Places of a later frame's mesh in the mesh of an earlier one. Faces keep their corners, which shows the
/// vertices that cracks have split. Vertices that were inserted in an edge or a face since then, and parts of
/// a face that has been split, lie flat in the earlier face.
struct FrameParents {
    std::vector<Index> faces;                    ///< [F] earlier face that each was, or was a part of
    std::vector<std::array<Index, 3>> vertices;  ///< [V] earlier vertices between which each was
    std::vector<std::array<double, 3>> weights;  ///< [V] shares of `vertices`, which sum to 1

    /// Interpolates values of the earlier vertices [3, ...] to the later ones [3, V].
    Positions interpolated_from(const Positions& earlier) const;
};

/// Throws Error (input) if the frames are not those of one run, in this order.
FrameParents frame_parents(const Snapshot& earlier, const Snapshot& later);

}  // namespace sherd
