// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/assemble/start/start_fault.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Checks for vertices of sheets that start inside an obstacle, and for faces that start across its surface
/// or too near to it. Contact would push such faces, and vertices deeper than a quarter of the thickness, out
/// violently or not at all. If Scene::exempts_overlaps is set, a warning is added for them; if not, an Error
/// names the scene's line and key, the sheet, their number and a place. Vertices that are less deep add a
/// warning in any case, and pinned vertices may be inside. inputs: all sheets, in the scene's order; `all` is
/// made from them, and `obstacles` from `specs`.
void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings);

/// Exempts the overlaps that require_free_start() reports from contact, until sheet and obstacle have
/// separated: a vertex is pushed only where it is deeper than at the start, and a face does not collide with
/// the surface that it starts across or near to (StartDepth). first: number of the first of these obstacles
/// among all colliders; all_colliders: number of all colliders.
void exempt_sheet_overlaps(const std::vector<SheetInput>& inputs, const std::vector<Obstacle>& obstacles,
                           std::size_t first, std::size_t all_colliders, BreakableShell& all);

/// Returns the faces for which require_free_start() throws, or would throw if overlaps were not exempt.
std::vector<StartFault> obstacle_faults(const std::vector<SheetInput>& inputs, const BreakableShell& all,
                                        const std::vector<Obstacle>& obstacles);

}  // namespace sherd
