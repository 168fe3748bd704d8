// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/partition_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace sherd {
namespace {

using Shares = std::map<Index, double>;

double squares(const auto& shares) {
    double sum = 0;
    for (const auto& [key, share] : shares) sum += share * share;
    return sum;
}

double entropy(const auto& shares) {
    double sum = 0;
    for (const auto& [key, share] : shares)
        if (share > 0) sum -= share * std::log(share);
    return sum;
}

/// Pairs of fragments with the largest common areas, in descending order; each fragment is in one pair at
/// most.
std::vector<PartitionMatch> matches_of(const PartitionOverlap& overlap, const Shares& first,
                                       const Shares& second) {
    std::vector<PartitionMatch> pairs, matches;
    for (const auto& [key, common] : overlap)
        pairs.push_back(
            {key.first, key.second, common, common / (first.at(key.first) + second.at(key.second) - common)});
    std::ranges::stable_sort(pairs, std::greater(), &PartitionMatch::common);
    std::set<Index> used_first, used_second;
    for (const PartitionMatch& pair : pairs) {
        if (used_first.contains(pair.first) || used_second.contains(pair.second)) continue;
        used_first.insert(pair.first), used_second.insert(pair.second);
        matches.push_back(pair);
    }
    return matches;
}

}  // namespace

double PartitionDistance::matched() const {
    double sum = 0;
    for (const PartitionMatch& match : matches) sum += match.common;
    return sum;
}

PartitionDistance partition_distance(const PartitionOverlap& overlap) {
    Shares first, second;
    for (const auto& [key, share] : overlap) first[key.first] += share, second[key.second] += share;
    // Probabilities that two points lie in one fragment: in the first partition, the second, and both.
    const double in_first = squares(first), in_second = squares(second), in_both = squares(overlap);
    const double by_chance = in_first * in_second, most = (in_first + in_second) / 2;
    PartitionDistance distance;
    distance.rand = 1 - (in_first + in_second - 2 * in_both);
    const bool both_are_whole = first.size() < 2 && second.size() < 2;
    distance.adjusted_rand = both_are_whole ? 1 : (in_both - by_chance) / (most - by_chance);
    distance.variation = std::max(0.0, 2 * entropy(overlap) - entropy(first) - entropy(second));
    distance.matches = matches_of(overlap, first, second);
    return distance;
}

}  // namespace sherd
