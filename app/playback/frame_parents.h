// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// For a later frame, where its faces and vertices were in the mesh of an earlier frame. Cracks that split
/// vertices leave the faces and the order of their corners unchanged, which shows the earlier vertex of each
/// later one. Vertices that were inserted in an edge or a face since the earlier frame, and parts of a face
/// that has been split, lie flat in the earlier face.
struct FrameParents {
    std::vector<Index> faces;                    ///< [F] earlier face that each face was or was a part of
    std::vector<std::array<Index, 3>> vertices;  ///< [V] earlier vertices between which each vertex was
    std::vector<std::array<double, 3>> weights;  ///< [V] shares of the three `vertices`; their sum is 1

    /// Returns values of the later vertices, [3, V], interpolated from values of the earlier vertices, a
    /// column each.
    Positions interpolated_from(const Positions& earlier) const;
};

/// Returns the places of the frame `later` in the mesh of `earlier`. Throws Error (input) if these are not
/// frames of one run in this order.
FrameParents frame_parents(const Snapshot& earlier, const Snapshot& later);

}  // namespace sherd
