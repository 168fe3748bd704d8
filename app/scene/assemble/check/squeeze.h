// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/shell/sheet_input.h"

namespace sherd {

/// Warnings about pairs of obstacles that come nearer to each other, by their keys, than the thickness of a
/// sheet.
struct SqueezedSheets {
    std::vector<std::string> certain;   ///< about sheets that get between the obstacles
    std::vector<std::string> possible;  ///< about sheets that may get there in flight
};

/// Checks all pairs of obstacles of which at least one moves, at 200 moments and at each key. Distances are
/// computed at the points of an obstacle's surface, and at those of its points that are nearest to the
/// middles of a sheet's faces, so that pairs of planes are checked, too. A sheet certainly gets between two
/// points that come together if it crosses the line between them at an earlier moment, where it starts or
/// where it would be in free flight. inputs, obstacles: made from the scene's, in its order.
SqueezedSheets squeezed_sheets(const Scene& scene, const std::vector<SheetInput>& inputs,
                               const std::vector<Obstacle>& obstacles);

/// Appends the warnings of squeezed_sheets() about a built scene, certain ones first.
void warn_of_squeezes(const Scene& scene, const BuiltScene& built, std::vector<std::string>& warnings);

}  // namespace sherd
