// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/contact_surface.h"

namespace sherd {

/// Returns the obstacles that have a surface. Pinned vertices that touch an obstacle at time 0, or are inside
/// it, do not collide with it, since it may be their support.
std::vector<ContactCollider> contact_colliders(const Shell& shell, const std::vector<Obstacle>& obstacles);

/// Returns the number of the first vertex of each obstacle in collider_positions().
std::vector<Index> first_vertices(const std::vector<Obstacle>& obstacles);

/// Positions at `time` (s) of the surface vertices of all obstacles, in the obstacles' order: [3, S] m.
Positions collider_positions(const std::vector<Obstacle>& obstacles, double time);

}  // namespace sherd
