// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/lanes.h"
#include "core/vector.h"

namespace sherd {

/// A point or a force in space, with a fourth number that means nothing, as memory gives it at once.
struct alignas(sizeof(Lanes)) Padded {
    Lanes coordinates;
};
using PaddedPositions = std::vector<Padded>;

/// One vector of each of four elements.
using LanesVector = Eigen::Matrix<Lanes, 3, 1>;
/// One number of each of four elements, as memory has it.
using LaneIndices = std::array<Index, Lanes::count>;

/// Those of four vertices.
inline LanesVector gather(const PaddedPositions& all, const LaneIndices& vertices) {
    Lanes a = all[vertices[0]].coordinates, b = all[vertices[1]].coordinates,
          c = all[vertices[2]].coordinates, d = all[vertices[3]].coordinates;
    transpose(a, b, c, d);
    return {a, b, c};
}

/// Puts them into four places from `first` on.
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

/// How many batches of four there are of so many elements.
constexpr Index batches_of(std::size_t elements) {
    return static_cast<Index>((elements + Lanes::count - 1) / Lanes::count);
}

/// How many elements batch b has, of so many in all.
constexpr int present_in(Index b, std::size_t elements) {
    return std::min<int>(Lanes::count, static_cast<int>(elements) - b * Lanes::count);
}
/// The element of a lane; the last one again where there are no more.
constexpr Index element_of(Index b, int lane, std::size_t elements) {
    return std::min(b * Lanes::count + lane, static_cast<Index>(elements) - 1);
}

}  // namespace sherd
