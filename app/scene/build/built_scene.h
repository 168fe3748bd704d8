// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// A scene as it is before its first step: all that a Simulation is made of.
struct BuiltScene {
    std::vector<SheetInput> inputs;  ///< of the scene's sheets, in its order, where they start
    BreakableShell sheets;           ///< made of all inputs
    SimulationOptions options;
};

/// Makes all that a scene says. It throws Error, naming the scene's line and key, on a sheet that cannot be
/// made, that is too thick for its mesh to hold its shape, or that does not start apart from others or free
/// of obstacles; on a load or a support that reaches nothing; and on an obstacle that cannot be made.
/// Warnings are sentences, also of sheets that were moved apart.
BuiltScene build_scene(const Scene& scene, std::vector<std::string>& warnings);

/// Does the same with sheets that make_sheet() has made: all of the scene, in its order.
BuiltScene build_scene(const Scene& scene, std::vector<SheetInput> inputs,
                       std::vector<std::string>& warnings);

}  // namespace sherd
