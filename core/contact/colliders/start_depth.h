// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/shell/shell.h"

namespace sherd {

/// Exempt overlap, m, of a vertex with a collider since the start: the collider pushes the vertex only where
/// it is deeper.
inline double start_depth(const Shell& shell, std::size_t collider, Index vertex) {
    return shell.start_depths.empty() ? 0 : shell.start_depths[collider].depth[vertex];
}

/// Exempts an overlap of a vertex with a collider at the start: the collider pushes the vertex only where it
/// is deeper than `depth` (m), and with `surface_exempt` elements with this vertex do not collide with the
/// collider's surface. colliders: number of obstacles and bodies.
void exempt_overlap(Shell& shell, std::size_t colliders, std::size_t collider, Index vertex, double depth,
                    bool surface_exempt);

/// Reduces the exempt depths to the present ones, and ends the exemption of elements that are too far from
/// the collider to reach its surface. time: s, of the obstacles' poses. Returns whether the exemption of any
/// elements has ended.
bool shrink_start_depths(Shell& shell, const std::vector<Obstacle>& obstacles,
                         std::span<const RigidBody> bodies, double time);

}  // namespace sherd
