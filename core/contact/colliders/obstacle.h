// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/collider.h"
#include "core/motion.h"

namespace sherd {

/// A collider that stands, or moves as it is told: what sheets and bodies cannot push away.
struct Obstacle : Collider {
    Motion motion;

    bool moves() const { return !motion.keys.empty(); }
};

}  // namespace sherd
