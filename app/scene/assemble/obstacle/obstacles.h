// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/assemble/sheet/thickness.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

/// Makes obstacles from their specs, in order; those of free bodies give obstacles at their start. Meshes and
/// level sets are read here. sheets: the range of thicknesses for which facets and distances must do. bodies:
/// free bodies that may touch the obstacles; distances reach as far as the largest ball's radius. Throws
/// Error naming the scene's line and key; warnings are sentences.
std::vector<Obstacle> make_obstacles(const std::vector<ObstacleSpec>& specs, const ThicknessRange& sheets,
                                     std::vector<std::string>& warnings,
                                     const std::vector<ObstacleSpec>& bodies = {});

/// Makes the scene's free bodies, in its order. Throws Error naming the scene's line and key if a mesh is no
/// solid.
std::vector<RigidBody> make_bodies(const Scene& scene, const ThicknessRange& sheets);

}  // namespace sherd
