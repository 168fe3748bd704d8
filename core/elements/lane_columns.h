// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/lanes.h"
#include "core/vector.h"

namespace sherd {

/// columns() of four elements of N vertices at once, [3, N]: of[lane] are the vertices of one.
template <std::size_t N>
Eigen::Matrix<Lanes, 3, static_cast<int>(N)> lane_columns(const Positions& x,
                                                          const std::array<Index, N> (&of)[Lanes::count]) {
    Eigen::Matrix<Lanes, 3, static_cast<int>(N)> local;
    for (std::size_t v = 0; v < N; ++v) {
        const double *a = x.data() + 3 * of[0][v], *b = x.data() + 3 * of[1][v], *c = x.data() + 3 * of[2][v],
                     *d = x.data() + 3 * of[3][v];
        for (int i = 0; i < 3; ++i) local(i, static_cast<int>(v)) = Lanes::Vector{a[i], b[i], c[i], d[i]};
    }
    return local;
}

/// Calls each(numbers) for groups of four of `count` elements, with their numbers; the last group repeats the
/// last number.
template <class Each>
void each_four(Index count, const Each& each) {
    wide_loop(0, (count + Lanes::count - 1) / Lanes::count, [&](Index group) {
        std::array<Index, Lanes::count> numbers;
        for (int lane = 0; lane < Lanes::count; ++lane)
            numbers[lane] = std::min(Lanes::count * group + lane, count - 1);
        each(numbers);
    });
}

}  // namespace sherd
