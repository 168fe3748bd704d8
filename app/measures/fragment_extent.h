// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// How long and how wide a fragment is at rest: its extents along the principal axes of its area, m.
struct FragmentExtent {
    double length = 0, width = 0;

    double aspect_ratio() const { return length / width; }
};

/// Of each fragment by its number; the axes are those of the second moments of its faces' area about its
/// centre, so that neither depends on the mesh but for its outline. Of a curved one these are chords.
std::vector<FragmentExtent> fragment_extents(const Snapshot& frame);

}  // namespace sherd
