// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/assemble/sheet/thickness.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

/// Makes obstacles from `specs`, in their order. A spec of a free body gives an obstacle in the body's
/// initial pose. Meshes and level sets are read from their files here. sheets: range of thicknesses from
/// which the fineness of facets and the reach of signed distances follow. bodies: free bodies that may touch
/// the obstacles; signed distances also reach as far as the radius of the largest ball. Throws Error naming
/// the scene's line and key; warnings are sentences.
std::vector<Obstacle> make_obstacles(const std::vector<ObstacleSpec>& specs, const ThicknessRange& sheets,
                                     std::vector<std::string>& warnings,
                                     const std::vector<ObstacleSpec>& bodies = {});

/// Makes the scene's free bodies, in its order. sheets: see make_obstacles(). Throws Error naming the scene's
/// line and key if a mesh is no solid.
std::vector<RigidBody> make_bodies(const Scene& scene, const ThicknessRange& sheets);

}  // namespace sherd
