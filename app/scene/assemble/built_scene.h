// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// A scene before its first step: the input of a Simulation.
struct BuiltScene {
    std::vector<SheetInput> inputs;  ///< inputs of the scene's sheets, in its order, where they start
    BreakableShell sheets;           ///< made from all inputs
    SimulationOptions options;
};

/// Builds a scene. Throws Error, naming the scene's line and key, on a sheet that cannot be made, that is too
/// thick to be stable on its mesh, or that does not start apart from other sheets and obstacles; on a load or
/// support that acts on nothing; on a gauge beside its sheet; and on an obstacle that cannot be made.
/// Warnings are sentences, also about sheets that were moved apart.
BuiltScene build_scene(const Scene& scene, std::vector<std::string>& warnings);

/// Builds a scene from the inputs that make_sheet() has made of all its sheets, in its order.
BuiltScene build_scene(const Scene& scene, std::vector<SheetInput> inputs,
                       std::vector<std::string>& warnings);

}  // namespace sherd
