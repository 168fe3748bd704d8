// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/recording/recording.h"
#include "core/vector.h"

namespace sherd {

/// Share of the area that a fragment of the first and one of the second partition have in common, by their
/// numbers.
using PartitionOverlap = std::map<std::pair<Index, Index>, double>;

/// A pair of matching fragments of two partitions.
struct PartitionMatch {
    Index first = 0, second = 0;
    double common = 0;      ///< share of the whole area in both fragments
    double over_union = 0;  ///< common area over that of the union: 1 for equal fragments
};

/// Distance of two partitions of an area; the numbers of fragments do not matter.
struct PartitionDistance {
    /// Rand index: probability that two points of the area, drawn at random, lie in one fragment in both
    /// partitions, or in different ones in both. (Rand, Objective criteria for the evaluation of clustering
    /// methods, 1971.)
    double rand = 1;
    /// Rand index corrected for chance: 1 only for equal partitions, 0 for fragments of these sizes at
    /// random. (Hubert and Arabie, Comparing partitions, 1985, in the limit of many points.)
    double adjusted_rand = 1;
    /// Variation of information, nats: 0 only for equal partitions. (Meila, Comparing clusterings, 2007.)
    double variation = 0;
    std::vector<PartitionMatch> matches;  ///< largest first; each fragment is in one at most

    double matched() const;  ///< share of the area that matches have in common
};

/// overlap: shares that sum to 1.
PartitionDistance partition_distance(const PartitionOverlap& overlap);

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
