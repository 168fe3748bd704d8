// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/build/start_fault.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Looks for vertices of sheets that start inside an obstacle, and for faces that start across its surface or
/// nearer to it than half the thickness. Pinned vertices may be inside. Where it is more than a quarter of
/// the thickness, or across, contact would push them out with violence or not at all: then, unless such
/// starts are exempt, it throws Error that names the scene's line and key, the sheet, how many there are and
/// where. Else it warns. The inputs are those of all sheets, in the scene's order; `all` is made of them, and
/// the obstacles are made of the specs.
void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings);

/// Lets the same vertices be as deep as they start, and faces not meet the surface that they start across or
/// near to, until they are out (StartDepth). first: number of the first of these obstacles among all
/// colliders.
void let_sheets_overlap(const std::vector<SheetInput>& inputs, const std::vector<Obstacle>& obstacles,
                        std::size_t first, std::size_t all_colliders, BreakableShell& all);

/// Returns the faces that are told of by require_free_start() as an error, or would be.
std::vector<StartFault> obstacle_faults(const std::vector<SheetInput>& inputs, const BreakableShell& all,
                                        const std::vector<Obstacle>& obstacles);

}  // namespace sherd
