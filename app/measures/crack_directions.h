// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "app/measures/crack_graph.h"

namespace sherd {

/// How cracks run at rest against the sheet's axis, by length, in degrees counterclockwise about its normal;
/// a crack has no sense, so that 180 is 0.
///
/// Of branches that have a shape. An edge has the direction of the chord over it and two more
/// on each side, as far as its branch goes, since edges themselves have the directions that the mesh offers.
struct CrackDirections {
    static constexpr std::size_t bins = 12;

    double length = 0;                     ///< m, of what counts
    std::array<double, bins> histogram{};  ///< shares of it, which sum to 1; bin i has its middle at 15 i
    double mean = 0;                       ///< 0 to 180: half the mean of doubled angles
    double resultant = 0;  ///< 1: all run that way; 0: none is preferred, and the mean means nothing
};

/// axes: of the faces of the unbroken mesh, [F0] or empty; a face without one has the projection of x, or of
/// y where x is its normal.
CrackDirections crack_directions(const CrackGraph& cracks, const RestMesh& rest,
                                 std::span<const Vector3d> axes);

/// A direction in the plane with this unit normal: the projection of `axis`, where that is none of x, or
/// else of y; a unit vector.
Vector3d in_plane_axis(const Vector3d& normal, const Vector3d& axis = Vector3d::Zero());

}  // namespace sherd
