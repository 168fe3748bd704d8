// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// A scene before its first step: the input of a Simulation.
struct BuiltScene {
    std::vector<SheetInput> inputs;  ///< inputs of the scene's sheets, in its order, at their start positions
    BreakableShell sheets;           ///< all sheets, made from `inputs`
    SimulationOptions options;
};

/// Builds a scene. Throws Error, naming the scene's line and key, on a sheet that cannot be made, that is too
/// thick to be stable on its mesh, or that does not start apart from other sheets and obstacles; on a load or
/// support that acts on nothing; on a gauge too far from its sheet; on an obstacle that cannot be made; and
/// on a free body that starts inside another collider. Adds warnings, which are sentences, also about sheets
/// that it has moved apart.
BuiltScene build_scene(const Scene& scene, std::vector<std::string>& warnings);

/// Builds a scene from inputs that make_sheet() has made, one for each of the scene's sheets, in the scene's
/// order.
BuiltScene build_scene(const Scene& scene, std::vector<SheetInput> inputs,
                       std::vector<std::string>& warnings);

}  // namespace sherd
