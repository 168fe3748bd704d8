// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/recording/recording.h"
#include "core/vector.h"

namespace sherd {

/// Share of the whole area that a fragment of the first partition and a fragment of the second partition have
/// in common, by the numbers of these two fragments.
using PartitionOverlap = std::map<std::pair<Index, Index>, double>;

/// A pair of matching fragments of two partitions.
struct PartitionMatch {
    Index first = 0, second = 0;  ///< numbers of the fragments
    double common = 0;            ///< share of the whole area that lies in both fragments
    double over_union = 0;  ///< common area over the area of the union of both fragments: 1 if they are equal
};

/// Distance of two partitions of an area into fragments. How the fragments are numbered does not matter.
struct PartitionDistance {
    /// Rand index: probability that two random points of the area lie in the same fragment in both
    /// partitions, or in different fragments in both partitions. (Rand, Objective criteria for the evaluation
    /// of clustering methods, 1971.)
    double rand = 1;
    /// Rand index corrected for chance: 1 only for equal partitions, 0 on average for random partitions into
    /// fragments of the same areas. (Hubert and Arabie, Comparing partitions, 1985, in the limit of many
    /// points.)
    double adjusted_rand = 1;
    /// Variation of information, nats: 0 only for equal partitions. (Meila, Comparing clusterings, 2007.)
    double variation = 0;
    std::vector<PartitionMatch> matches;  ///< descending by common area; no fragment is in two matches

    double matched() const;  ///< share of the whole area that lies in both fragments of a match
};

/// Returns the distance of two partitions. overlap: shares whose sum is 1.
PartitionDistance partition_distance(const PartitionOverlap& overlap);

/// Difference between the fragments of two frames. All positions are at rest.
struct FragmentDistance {
    PartitionDistance partition;  ///< distance of the first frame's fragments from the second frame's
    double gap = 0;               ///< m, largest distance of a point on one frame's sheets from the other's
                                  ///< sheets
};

/// Returns the difference between two frames, whose meshes may differ. Three points represent the area of
/// each face of both frames; each point counts for the fragment of its own face and for the fragment of the
/// nearest face of the other frame. Both frames have equal weight, whatever their areas.
FragmentDistance fragment_distance(const Snapshot& first, const Snapshot& second);

/// Returns the difference between the last frames of two recordings. Throws Error (input) if a recording is
/// damaged or has no frame.
FragmentDistance fragment_distance(const Recording& first, const Recording& second);

/// Returns a JSON object; its keys are described in docs/commands.md.
std::string distance_json(const FragmentDistance& distance);

/// Returns a text for users.
std::string distance_text(const FragmentDistance& distance);

}  // namespace sherd
