// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/lanes.h"
#include "core/vector.h"

namespace sherd {

/// A point or a force in space, padded by an unused fourth number so that it is read at once.
struct alignas(sizeof(Lanes)) Padded {
    Lanes coordinates;
};
using PaddedPositions = std::vector<Padded>;

/// Four vectors, one for each of four elements.
using LanesVector = Eigen::Matrix<Lanes, 3, 1>;
/// Four indices, one for each of four elements.
using LaneIndices = std::array<Index, Lanes::count>;

/// Reads the vectors of four vertices.
inline LanesVector gather(const PaddedPositions& all, const LaneIndices& vertices) {
    Lanes a = all[vertices[0]].coordinates, b = all[vertices[1]].coordinates,
          c = all[vertices[2]].coordinates, d = all[vertices[3]].coordinates;
    transpose(a, b, c, d);
    return {a, b, c};
}

/// Writes four vectors to the places from `first` on.
inline void scatter(const LanesVector& vectors, Padded* first) {
    Lanes a = vectors[0], b = vectors[1], c = vectors[2], d = 0;
    transpose(a, b, c, d);
    first[0].coordinates = a;
    first[1].coordinates = b;
    first[2].coordinates = c;
    first[3].coordinates = d;
}

inline Lanes gather(const std::vector<double>& all, const LaneIndices& at) {
    return Lanes::Vector{all[at[0]], all[at[1]], all[at[2]], all[at[3]]};
}

inline void scatter(const Lanes& values, const LaneIndices& at, std::vector<double>& all) {
    for (int lane = 0; lane < Lanes::count; ++lane) all[at[lane]] = values[lane];
}

/// Number of batches of four for a number of elements.
constexpr Index batches_of(std::size_t elements) {
    return static_cast<Index>((elements + Lanes::count - 1) / Lanes::count);
}

/// Number of elements in batch b, of `elements` in all.
constexpr int present_in(Index b, std::size_t elements) {
    return std::min<int>(Lanes::count, static_cast<int>(elements) - b * Lanes::count);
}
/// The place in order of the element in a lane of batch b; lanes that are left over in the last batch repeat
/// the last element.
constexpr Index element_of(Index b, int lane, std::size_t elements) {
    return std::min(b * Lanes::count + lane, static_cast<Index>(elements) - 1);
}

/// Contributions of elements to their corners, and their sum at each vertex. Each contribution has a place of
/// its own, so that several are computed at a time; a sum always runs in the order of places.
class CornerSums {
  public:
    void clear() { vertex_of.clear(); }
    /// Appends places for the corners of the elements in a batch, and returns the number of the first place.
    /// vertices: for each corner, its vertex in each of the four elements; present: number of elements in the
    /// batch; the places of the other lanes are left out of all sums.
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
    /// Writes the negative sums of `some` vertices to their entries of of_all, [3, V].
    void put_negative(std::span<const Index> some, double* of_all) const;

  private:
    void put_negative(Index vertex, double* of_all) const;

    std::vector<Index> vertex_of;         ///< vertex of each place; -1: none
    std::vector<Index> start, at_vertex;  ///< [V + 1] where each vertex begins in at_vertex; places, ordered
                                          ///< by vertex
    PaddedPositions places;
};

}  // namespace sherd
