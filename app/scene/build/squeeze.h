// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/build/built_scene.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/sheet_input.h"

namespace sherd {

/// Sentences about pairs of obstacles that come nearer to each other by their keys than a sheet is thick.
struct SqueezedSheets {
    std::vector<std::string> certain;   ///< the sheet starts between what comes together
    std::vector<std::string> possible;  ///< it may get there while it flies
};

/// Looks at all pairs of obstacles of which one moves, at 200 moments and at each key. Distances are asked
/// for at the points of an obstacle's surface, and where the middles of a sheet's faces lie on it, so that
/// two planes are seen, too. A sheet is between two points that come together if it crosses the line between
/// them before that, where it starts or where it would have flown. Inputs and obstacles are those of the
/// scene, in its order.
SqueezedSheets squeezed_sheets(const Scene& scene, const std::vector<SheetInput>& inputs,
                               const std::vector<Obstacle>& obstacles);

/// Appends both kinds, for what runs a scene.
void warn_of_squeezes(const Scene& scene, const BuiltScene& built, std::vector<std::string>& warnings);

}  // namespace sherd
