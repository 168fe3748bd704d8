// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/measures/partition_distance.h"
#include "app/recording/recording.h"

namespace sherd {

/// Difference between the fragments of two frames, at rest.
struct FragmentDistance {
    PartitionDistance partition;  ///< fragments of the first frame against those of the second
    double gap = 0;               ///< m, largest distance of a point of one frame's sheets from the other's
};

/// Overlays the sheets at rest: three points of each face of either frame represent its area, and each
/// belongs to the nearest face of the other frame. So meshes may differ, and both frames have equal weight,
/// with a total area of 1 each.
FragmentDistance fragment_distance(const Snapshot& first, const Snapshot& second);

/// Compares the last frames. Throws Error (input) if a recording is damaged, or has no frame.
FragmentDistance fragment_distance(const Recording& first, const Recording& second);

/// Returns a JSON object; its keys are described in docs/commands.md.
std::string distance_json(const FragmentDistance& distance);

/// Returns a text for users.
std::string distance_text(const FragmentDistance& distance);

}  // namespace sherd
