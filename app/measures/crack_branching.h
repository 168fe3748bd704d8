// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/measures/crack_graph.h"

namespace sherd {

/// Where three branches or more meet, not on the rim.
struct CrackJunction {
    Vector3d position = Vector3d::Zero();  ///< m, at rest
    std::size_t branches = 0;              ///< that end here
    /// Degrees, between neighbours around it, which sum to 360: of each the direction of the chord over its
    /// first three edges. Empty where a branch has no shape: it is not clear what forks there.
    std::vector<double> angles = {};

    double smallest_angle() const;  ///< there must be angles
};

/// By the number of their vertex at rest.
std::vector<CrackJunction> crack_junctions(const CrackGraph& cracks, const RestMesh& rest);

/// Degrees, mean of the smallest angles of those junctions that have angles.
std::optional<double> branching_angle(std::span<const CrackJunction> junctions);

}  // namespace sherd
