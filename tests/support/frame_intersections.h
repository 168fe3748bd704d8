// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/snapshot.h"
#include "meshops/self_intersections.h"

namespace sherd::test {

/// Pairs of faces of a frame that have more in common than they share as neighbours.
struct FrameIntersections {
    std::vector<std::array<Face, 2>> passing;  ///< through each other: there must be none
    std::size_t lips =
        0;  ///< at a vertex that a crack has split, where they lie on each other until they part
};

/// mesh: that of the frame. By exact predicates.
inline FrameIntersections frame_intersections(const Snapshot& frame, const Mesh& mesh) {
    FrameIntersections found;
    for (const auto& pair : self_intersections(mesh)) {
        bool split = false;
        for (const Index p : frame.faces[pair[0]])
            for (const Index q : frame.faces[pair[1]]) split |= frame.original[p] == frame.original[q];
        if (split)
            ++found.lips;
        else
            found.passing.push_back(pair);
    }
    return found;
}

}  // namespace sherd::test
