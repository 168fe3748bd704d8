// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/crack_extent.h"

#include <map>
#include <set>
#include <utility>

namespace sherd {
namespace {

using Ends = std::pair<Index, Index>;

Ends ordered(Index a, Index b) {
    return a < b ? Ends{a, b} : Ends{b, a};
}

/// A face that has an edge at rest, and that edge as it is now.
struct Side {
    std::size_t face;
    Ends now;
};

}  // namespace

CrackExtent crack_extent(const Snapshot& frame) {
    std::set<Ends> failed;
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        if (frame.edge_state[e] == EdgeState::fractured_interior)
            failed.insert(ordered(frame.edges[e][0], frame.edges[e][1]));
    const auto thickness = [&](std::size_t face) {
        return frame.rest.thickness.empty() ? 0.0 : frame.rest.thickness[face];
    };
    CrackExtent extent;
    std::map<Ends, Side> first_sides;
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            const Index a = frame.rest.faces[f][i], b = frame.rest.faces[f][next];
            const Side side{f, ordered(frame.faces[f][i], frame.faces[f][next])};
            const auto [other, is_first] = first_sides.try_emplace(ordered(a, b), side);
            if (is_first) continue;
            if (other->second.now == side.now && !failed.contains(side.now)) continue;
            const double length = (frame.rest.position.col(a) - frame.rest.position.col(b)).norm();
            extent.length += length;
            extent.area += length * (thickness(f) + thickness(other->second.face)) / 2;
        }
    return extent;
}

}  // namespace sherd
