// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/contact_surface.h"

namespace sherd {

/// The obstacles that have a surface, as they stand at time 0. Pinned vertices that touch an obstacle at that
/// time, or are inside it, do not collide with it: it may be what holds them.
std::vector<ContactCollider> contact_colliders(const Shell& shell, const std::vector<Obstacle>& obstacles);

/// The number of the first vertex of each obstacle among those of all, as collider_positions() has them.
std::vector<Index> first_vertices(const std::vector<Obstacle>& obstacles);

/// Positions at `time` (s) of the vertices of the same obstacles, in their order: [3, S] m.
Positions collider_positions(const std::vector<Obstacle>& obstacles, double time);

}  // namespace sherd
