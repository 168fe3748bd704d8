// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/elements/dihedral_angle.h"
#include "core/lanes.h"
#include "core/vector.h"

namespace sherd {

/// Reads the columns() of four elements of N vertices, one element in each lane: [3, N]. of[lane]: vertices
/// of the element in this lane.
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

/// Calls each(numbers) with the numbers of four elements for each group of four among `count` elements. In
/// the last group the last number is repeated.
template <class Each>
void each_four(Index count, const Each& each) {
    wide_loop(0, (count + Lanes::count - 1) / Lanes::count, [&](Index group) {
        std::array<Index, Lanes::count> numbers;
        for (int lane = 0; lane < Lanes::count; ++lane)
            numbers[lane] = std::min(Lanes::count * group + lane, count - 1);
        each(numbers);
    });
}

/// Calls put(i, angle) for each of `count` hinges, with hinge_angle() of hinge i at x, [3, V] m. Angles are
/// computed four at a time. vertices_of(i): the vertices of hinge i, as an array.
template <class VerticesOf, class Put>
void find_hinge_angles(const Positions& x, Index count, const VerticesOf& vertices_of, const Put& put) {
    each_four(count, [&](const std::array<Index, Lanes::count>& hinges) {
        std::array<Index, 4> vertices[Lanes::count];
        for (int lane = 0; lane < Lanes::count; ++lane) vertices[lane] = vertices_of(hinges[lane]);
        const Lanes angles = DihedralAngleOf<Lanes>(lane_columns(x, vertices)).angle();
        for (int lane = 0; lane < Lanes::count; ++lane) put(hinges[lane], angles[lane]);
    });
}

/// hinge_strain() of a hinge with the angle `angle`, rad.
double hinge_strain(const RestHinge& rest, double angle);

}  // namespace sherd
