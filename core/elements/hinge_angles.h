// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/dihedral_angle.h"
#include "core/elements/lane_columns.h"

namespace sherd {

/// Calls put(i, angle) with hinge_angle() at x, [3, V] m, of `count` hinges, which are computed four at a
/// time. vertices_of(i): the vertices of hinge i, as an array.
template <class VerticesOf, class Put>
void find_hinge_angles(const Positions& x, Index count, const VerticesOf& vertices_of, const Put& put) {
    each_four(count, [&](const std::array<Index, Lanes::count>& hinges) {
        std::array<Index, 4> vertices[Lanes::count];
        for (int lane = 0; lane < Lanes::count; ++lane) vertices[lane] = vertices_of(hinges[lane]);
        const Lanes angles = DihedralAngleOf<Lanes>(lane_columns(x, vertices)).angle();
        for (int lane = 0; lane < Lanes::count; ++lane) put(hinges[lane], angles[lane]);
    });
}

/// hinge_strain() of a hinge that has this angle, rad.
double hinge_strain(const RestHinge& rest, double angle);

}  // namespace sherd
