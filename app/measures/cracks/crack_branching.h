// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// A vertex at which three or more branches of cracks meet, not on the rim.
struct CrackJunction {
    Vector3d position = Vector3d::Zero();  ///< m, at rest
    std::size_t branches = 0;              ///< number of branches that end here
    /// Angles between neighbouring branches, degrees, which sum to 360; the direction of a branch is the
    /// chord over its first three edges. Empty if a branch has no shape, so that its direction is unclear.
    std::vector<double> angles = {};

    double smallest_angle() const;  ///< requires angles
};

/// Returns the junctions, in the order of their vertices at rest.
std::vector<CrackJunction> crack_junctions(const CrackGraph& cracks, const RestMesh& rest);

/// Mean of the smallest angles of the junctions that have angles, degrees.
std::optional<double> branching_angle(std::span<const CrackJunction> junctions);

}  // namespace sherd
