// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/contact_surface.h"

namespace sherd {

/// Those obstacles that have a surface, as they stand at time 0. Pinned vertices that touch an obstacle
/// there, or are inside it, do not meet it: it may be what holds them.
std::vector<ContactSolid> contact_solids(const Sheet& sheet, const std::vector<Obstacle>& obstacles);

/// Where the vertices of the same obstacles are at `time` (s), one after the other: [3, S] m.
Positions solid_positions(const std::vector<Obstacle>& obstacles, double time);

}  // namespace sherd
