// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/build/start_fault.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Looks for vertices of sheets that start inside an obstacle, and for faces that start across its surface or
/// nearer to it than half the thickness. Pinned vertices may be inside. Where it is more than a quarter of
/// the thickness, or across, contact would push them out with violence or not at all: then it throws Error
/// that names the scene's line and key, the sheet, how many there are and where. Where it is less, it warns.
/// The inputs are those of all sheets, in the scene's order; `all` is made of them, and the obstacles are
/// made of the specs.
void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings);

/// Returns the faces for which require_free_start() throws.
std::vector<StartFault> obstacle_faults(const std::vector<SheetInput>& inputs, const BreakableShell& all,
                                        const std::vector<Obstacle>& obstacles);

}  // namespace sherd
