// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/build/thickness.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

/// Makes obstacles of a scene, in its order, as they are without being free, for sheets that are so thick.
/// Meshes and level sets are read here; bodies: the free ones that meet them, whose balls are felt as far off
/// as they are large. Throws Error naming the scene's line and key; warnings are sentences.
std::vector<Obstacle> make_obstacles(const std::vector<ObstacleSpec>& specs, const ThicknessRange& sheets,
                                     std::vector<std::string>& warnings,
                                     const std::vector<ObstacleSpec>& bodies = {});

/// Makes the scene's free bodies, in its order. Throws Error naming the scene's line and key where a mesh is
/// no solid.
std::vector<RigidBody> make_bodies(const Scene& scene, const ThicknessRange& sheets);

}  // namespace sherd
