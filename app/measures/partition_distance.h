// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Share of the area that a fragment of one partition and one of another have in common, by their numbers.
using PartitionOverlap = std::map<std::pair<Index, Index>, double>;

/// Fragments of two partitions that belong together.
struct PartitionMatch {
    Index first = 0, second = 0;
    double common = 0;      ///< share of the whole area that they have in common
    double over_union = 0;  ///< that over the area that either has: 1 when they are the same
};

/// How alike two partitions of an area are; which numbers fragments have does not matter.
struct PartitionDistance {
    /// Rand index: how probable it is that two points of the area, drawn at random, lie in one fragment in
    /// both partitions, or in none. (Rand, Objective criteria for the evaluation of clustering methods,
    /// 1971.)
    double rand = 1;
    /// That less what fragments of these sizes have by chance, over what is left: 1 only of equal ones, 0 by
    /// chance. (Hubert and Arabie, Comparing partitions, 1985, in the limit of many points.)
    double adjusted_rand = 1;
    /// Variation of information, nats: 0 only of equal ones. (Meila, Comparing clusterings, 2007.)
    double variation = 0;
    std::vector<PartitionMatch> matches;  ///< largest first; each fragment is in one at most

    double matched() const;  ///< share of the area that matches have in common
};

/// overlap: shares that sum to 1.
PartitionDistance partition_distance(const PartitionOverlap& overlap);

}  // namespace sherd
