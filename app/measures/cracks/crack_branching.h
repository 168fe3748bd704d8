// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// A vertex, not on the rim, at which three or more branches of cracks meet.
struct CrackJunction {
    Vector3d position = Vector3d::Zero();  ///< m, at rest
    std::size_t branches = 0;              ///< number of branches that end here
    /// Angles between neighbouring branches, degrees; their sum is 360. The direction of a branch is that of
    /// the chord over its first three edges. Empty if one of the branches has no shape
    /// (CrackBranch::has_shape()), since its direction is then unclear.
    std::vector<double> angles = {};

    double smallest_angle() const;  ///< degrees; requires that `angles` is not empty
};

/// Returns the junctions in ascending order of their vertices' numbers at rest.
std::vector<CrackJunction> crack_junctions(const CrackGraph& cracks, const RestMesh& rest);

/// Returns the mean of the smallest angles of the junctions that have angles, degrees; none if there are
/// none.
std::optional<double> branching_angle(std::span<const CrackJunction> junctions);

}  // namespace sherd
