// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Length and width of a fragment at rest: its extents along the principal axes of its area, m.
struct FragmentExtent {
    double length = 0, width = 0;

    double aspect_ratio() const { return length / width; }
};

/// Returns the extents of each fragment by its number. The axes are those of the second moments of its area
/// about its centroid, so that extents depend on the mesh by its outline only. Extents of a curved fragment
/// are chords.
std::vector<FragmentExtent> fragment_extents(const Snapshot& frame);

}  // namespace sherd
