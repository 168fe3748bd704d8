// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "core/contact/obstacle.h"
#include "fracture/breakable_sheet.h"

namespace sherd {

/// Looks for vertices of sheets that start inside an obstacle; pinned ones may. Deeper than a quarter of the
/// thickness, which contact pushes out with violence, it throws Error that names the scene's line and key,
/// the sheet, how many vertices there are and where the deepest is; less deep, it warns. inputs: of all
/// sheets, in the scene's order; obstacles: made of specs.
void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings);

}  // namespace sherd
