// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/fragments/fragment_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>

#include "app/json/json.h"
#include "app/messages/counted.h"
#include "meshops/error.h"
#include "meshops/intersect/nearest_triangle.h"

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

/// Returns pairs of fragments, one of each partition, in descending order of their common area. Each fragment
/// is in one pair at most: pairs with larger common areas are chosen first. first, second: areas of the
/// fragments of both partitions.
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

/// Represents the area of each face of `from` by points. Calls take(fragment of `from` at the point, fragment
/// of the nearest face of `to`, share of the area of `from`) for each point; returns the largest distance of
/// a point from `to`, m.
template <class Take>
double overlay(const Snapshot& from, const Snapshot& to, Take take) {
    const NearestTriangle nearest(to.rest.position, to.rest.faces);
    const double area = std::accumulate(from.rest.area.begin(), from.rest.area.end(), 0.0);
    // Points of the quadrature rule of degree 2 (Strang and Fix 1973). They lie inside a face, so that the
    // nearest face of an equal mesh is unique.
    const Matrix3d weights = Matrix3d::Constant(1.0 / 6) + 0.5 * Matrix3d::Identity();
    double farthest = 0;
    for (std::size_t f = 0; f < from.faces.size(); ++f) {
        const Matrix3d points = columns(from.rest.position, from.rest.faces[f]) * weights;
        for (int i = 0; i < 3; ++i) {
            const NearestTriangle::Found found = nearest(points.col(i));
            take(from.face_fragment[f], to.face_fragment[found.triangle], from.rest.area[f] / (3 * area));
            farthest = std::max(farthest, found.distance);
        }
    }
    return farthest;
}

Snapshot last_frame(const Recording& recording) {
    const std::size_t frames = recording.frame_count();
    if (frames == 0) throw Error("a recording has no frame yet: there is nothing to compare");
    return recording.frame(frames - 1);
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
    // Probabilities that two random points lie in the same fragment of the first partition, of the second
    // partition, and of both partitions.
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

FragmentDistance fragment_distance(const Snapshot& first, const Snapshot& second) {
    PartitionOverlap overlap;
    const double there = overlay(first, second, [&](Index of_first, Index of_second, double share) {
        overlap[{of_first, of_second}] += share / 2;
    });
    const double back = overlay(second, first, [&](Index of_second, Index of_first, double share) {
        overlap[{of_first, of_second}] += share / 2;
    });
    return {partition_distance(overlap), std::max(there, back)};
}

FragmentDistance fragment_distance(const Recording& first, const Recording& second) {
    return fragment_distance(last_frame(first), last_frame(second));
}

std::string distance_json(const FragmentDistance& distance) {
    const PartitionDistance& partition = distance.partition;
    Json matches = Json::array();
    for (const auto& [first, second, common, over_union] : partition.matches)
        matches.push_back(
            {{"first", first}, {"second", second}, {"common", common}, {"over_union", over_union}});
    const Json json{{"rand", partition.rand},
                    {"adjusted_rand", partition.adjusted_rand},
                    {"variation", partition.variation},
                    {"matched", partition.matched()},
                    {"gap", distance.gap},
                    {"matches", matches}};
    return json.dump(2) + "\n";
}

std::string distance_text(const FragmentDistance& distance) {
    constexpr std::size_t most = 20;
    const PartitionDistance& partition = distance.partition;
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "Rand index   {:.6g}, adjusted {:.6g}\nvariation    {:.6g} nats of information\n"
                   "matches      {} fragments, {:.4g} % of the area\n",
                   partition.rand, partition.adjusted_rand, partition.variation, partition.matches.size(),
                   100 * partition.matched());
    fmt::format_to(out, "gap          {:.4g} m at most from one sheet to the other, at rest\n", distance.gap);
    fmt::format_to(out, "  {:>6} {:>6} {:>12} {:>12}\n", "first", "second", "common %", "of both %");
    for (std::size_t i = 0; i < std::min(most, partition.matches.size()); ++i) {
        const auto& [first, second, common, over_union] = partition.matches[i];
        fmt::format_to(out, "  {:>6} {:>6} {:>12.4g} {:>12.4g}\n", first, second, 100 * common,
                       100 * over_union);
    }
    if (partition.matches.size() > most)
        fmt::format_to(out, "  and {}\n", counted(partition.matches.size() - most, "smaller one"));
    return text;
}

}  // namespace sherd
