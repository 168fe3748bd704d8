// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/contact_surface.h"

namespace sherd {

/// Returns the obstacles that have a surface, as colliders for ContactSurface. Pinned vertices that touch an
/// obstacle at time 0, or are inside it, are exempt from contact with its surface, since the obstacle may be
/// their support.
std::vector<ContactCollider> contact_colliders(const Shell& shell, const std::vector<Obstacle>& obstacles);

/// Returns for each obstacle the column of its first vertex in collider_positions().
std::vector<Index> first_vertices(const std::vector<Obstacle>& obstacles);

/// Returns the positions, [3, S] m, at `time` (s) of the surface vertices of all obstacles, in the order of
/// the obstacles.
Positions collider_positions(const std::vector<Obstacle>& obstacles, double time);

}  // namespace sherd
