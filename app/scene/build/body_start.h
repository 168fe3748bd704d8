// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

/// Throws Error, with the scene's lines and keys, if a free body starts inside an obstacle or another body,
/// whose contact springs would fling it out. The obstacles and bodies are those of the scene, in its order.
void require_free_bodies(const Scene& scene, const std::vector<Obstacle>& obstacles,
                         const std::vector<RigidBody>& bodies);

}  // namespace sherd
