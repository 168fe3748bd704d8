// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Distribution of the directions of cracks at rest, weighted by length. A direction is an angle, degrees,
/// measured from the axis of the sheet counterclockwise about its normal. A crack has no sense, so that 180
/// degrees are the same as 0.
///
/// Only branches that have a shape count (CrackBranch::has_shape()). The direction of an edge is that of a
/// chord over the edge and up to two more edges of its branch on each side, since the directions of single
/// edges are those of the mesh.
struct CrackDirections {
    static constexpr std::size_t bins = 12;

    double length = 0;                     ///< m, total length of the branches that count
    std::array<double, bins> histogram{};  ///< shares of `length`; the middle of bin i is 15 i degrees
    double mean = 0;                       ///< degrees, 0 to 180: half the mean of the doubled angles
    double resultant = 0;                  ///< 1: all cracks have the mean direction; 0: no preferred one
};

/// Returns the directions of `cracks`. axes: [F0] axis of each face of the unfractured mesh, or empty.
/// in_plane_axis() projects the axis into the face, and replaces an axis that is zero or missing.
CrackDirections crack_directions(const CrackGraph& cracks, const RestMesh& rest,
                                 std::span<const Vector3d> axes);

/// Returns a unit vector in the plane whose unit normal is `normal`: the direction of the projection of
/// `axis`; if that vanishes, of the x axis, and if that vanishes, too, of the y axis.
Vector3d in_plane_axis(const Vector3d& normal, const Vector3d& axis = Vector3d::Zero());

}  // namespace sherd
