// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/measures/partition_distance.h"
#include "app/recording/recording.h"

namespace sherd {

/// How alike the fragments of two frames lie at rest.
struct FragmentDistance {
    PartitionDistance partition;  ///< of the first frame against the second one
    double gap = 0;               ///< m, farthest that a point of one sheet lies from the other's sheets
};

/// Sheets are overlaid where they are at rest: each of three points of each face of either frame, which stand
/// for its area, belongs to the face of the other frame that is nearest. So meshes may differ, and both
/// frames count alike, each as a whole of 1.
FragmentDistance fragment_distance(const Snapshot& first, const Snapshot& second);

/// Of the last frames. Throws Error (input) when a recording is damaged, or has no frame.
FragmentDistance fragment_distance(const Recording& first, const Recording& second);

/// One JSON object; its keys are described in app/README.md.
std::string distance_json(const FragmentDistance& distance);

/// The same for people to read.
std::string distance_text(const FragmentDistance& distance);

}  // namespace sherd
