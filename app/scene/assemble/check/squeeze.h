// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "fracture/shell/sheet_input.h"

namespace sherd {

/// Sentences about pairs of obstacles whose keys bring them nearer to each other than the thickness of a
/// sheet.
struct SqueezedSheets {
    std::vector<std::string> certain;   ///< the sheet gets between the obstacles
    std::vector<std::string> possible;  ///< the sheet may get there in flight
};

/// Checks all pairs of obstacles of which at least one moves, at 200 moments and at each key. Distances are
/// computed at the points of an obstacle's surface, and at its points nearest to the middles of a sheet's
/// faces, so that pairs of planes are found, too. A sheet is between two points that come together if it
/// crosses the line between them earlier, either where it starts or where it would be in free flight. Inputs
/// and obstacles are those of the scene, in its order.
SqueezedSheets squeezed_sheets(const Scene& scene, const std::vector<SheetInput>& inputs,
                               const std::vector<Obstacle>& obstacles);

/// Appends the sentences of both kinds, for a run of the scene.
void warn_of_squeezes(const Scene& scene, const BuiltScene& built, std::vector<std::string>& warnings);

}  // namespace sherd
