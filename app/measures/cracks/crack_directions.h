// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Directions of cracks at rest against the sheet's axis, by length, in degrees counterclockwise about its
/// normal; a crack has no sense, so that 180 is 0.
///
/// Only branches that have a shape count. The direction of an edge is that of the chord over it and two more
/// edges on each side, as far as its branch reaches, since edges themselves have the directions of the mesh.
struct CrackDirections {
    static constexpr std::size_t bins = 12;

    double length = 0;                     ///< m, of the branches that count
    std::array<double, bins> histogram{};  ///< shares of length, which sum to 1; the middle of bin i is 15 i
    double mean = 0;                       ///< 0 to 180: half the mean of doubled angles
    double resultant = 0;                  ///< 1: all have the mean direction; 0: none is preferred
};

/// axes: of the faces of the unfractured mesh, [F0] or empty; a face without one has the projection of x, or
/// of y if x is its normal.
CrackDirections crack_directions(const CrackGraph& cracks, const RestMesh& rest,
                                 std::span<const Vector3d> axes);

/// Returns a unit vector in the plane with this unit normal: the projection of `axis`, or, if that vanishes,
/// of x, or else of y.
Vector3d in_plane_axis(const Vector3d& normal, const Vector3d& axis = Vector3d::Zero());

}  // namespace sherd
