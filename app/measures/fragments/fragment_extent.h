// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Length and width of a fragment at rest, m: its larger and its smaller extent along the principal axes of
/// its area.
struct FragmentExtent {
    double length = 0, width = 0;

    double aspect_ratio() const { return length / width; }
};

/// Returns the extent of each fragment, by the fragment's number. The principal axes are those of the second
/// moments of the fragment's area about its centroid, so that only the outline of the fragment matters, not
/// the mesh inside it. Extents of a curved fragment are straight distances between points. A fragment without
/// faces has the extent 0.
std::vector<FragmentExtent> fragment_extents(const Snapshot& frame);

}  // namespace sherd
