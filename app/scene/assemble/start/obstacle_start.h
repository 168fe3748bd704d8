// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/assemble/start/start_fault.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Checks for vertices of sheets that start inside an obstacle, and for faces that start across its surface
/// or too near to it. Pinned vertices may be inside. Vertices deeper than a quarter of the thickness, and
/// such faces, contact would push out violently or not at all: unless they are exempt, an Error names the
/// scene's line and key, the sheet, their number and a place. Exempt starts, and shallower vertices, add
/// warnings. `inputs` has all sheets, in the scene's order; `all` is made from them, and the
/// obstacles are made from the specs.
void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings);

/// Exempts such starts from contact: vertices are not pushed out of their depth at the start, and faces do
/// not collide with the surface that they start across or near to, until they have separated (StartDepth).
/// first: number of the first of these obstacles among all colliders.
void exempt_sheet_overlaps(const std::vector<SheetInput>& inputs, const std::vector<Obstacle>& obstacles,
                           std::size_t first, std::size_t all_colliders, BreakableShell& all);

/// Returns the faces for which require_free_start() throws, or would throw if starts were not exempt.
std::vector<StartFault> obstacle_faults(const std::vector<SheetInput>& inputs, const BreakableShell& all,
                                        const std::vector<Obstacle>& obstacles);

}  // namespace sherd
