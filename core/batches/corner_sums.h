// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batches/padded.h"

namespace sherd {

/// Contributions of elements to their corners, each in a place of its own, so that many are computed at a
/// time, and their sum at each vertex, always in the order of places.
class CornerSums {
  public:
    void clear() { vertex_of.clear(); }
    /// Appends places for the corners of a batch, given by the vertices of one corner after the other, and
    /// returns the number of the first. present: number of elements in the batch; the places of other lanes
    /// are left out of all sums.
    template <std::size_t Corners>
    Index append(const std::array<LaneIndices, Corners>& vertices, int present) {
        const Index first = static_cast<Index>(vertex_of.size());
        for (const LaneIndices& corner : vertices)
            for (int lane = 0; lane < Lanes::count; ++lane)
                vertex_of.push_back(lane < present ? corner[lane] : -1);
        return first;
    }
    /// Must be called when all places have been appended.
    void prepare(Index vertices);

    Padded* at(Index place) { return places.data() + place; }
    /// Writes the negative sums of the vertices from `begin` to before `end` to their entries of of_all, [3,
    /// V].
    void put_negative(Index begin, Index end, double* of_all) const;

  private:
    std::vector<Index> vertex_of;         ///< vertex of each place; -1: none
    std::vector<Index> start, at_vertex;  ///< places of each vertex, and where they begin
    PaddedPositions places;
};

}  // namespace sherd
