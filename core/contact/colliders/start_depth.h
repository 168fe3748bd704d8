// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/shell/shell.h"

namespace sherd {

/// Exempt overlap, m, that remains from an overlap of the vertex with the collider at the start of the run:
/// the collider pushes the vertex only if it is deeper. collider: number in Shell::start_depths, obstacles
/// first.
inline double start_depth(const Shell& shell, std::size_t collider, Index vertex) {
    return shell.start_depths.empty() ? 0 : shell.start_depths[collider].depth[vertex];
}

/// Exempts an overlap of a vertex with a collider at the start of the run: the collider pushes the vertex
/// only if it is deeper than `depth` (m). If `surface_exempt` is true, elements with this vertex do not
/// collide with the collider's surface. colliders: number of all obstacles and bodies; collider: number in
/// Shell::start_depths, obstacles first.
void exempt_overlap(Shell& shell, std::size_t colliders, std::size_t collider, Index vertex, double depth,
                    bool surface_exempt);

/// Reduces each exempt depth to the present overlap, and ends the exemption of elements that are too far from
/// the collider to reach its surface. time: s, for the obstacles' poses. Returns whether the exemption of any
/// element has ended.
bool shrink_start_depths(Shell& shell, const std::vector<Obstacle>& obstacles,
                         std::span<const RigidBody> bodies, double time);

}  // namespace sherd
