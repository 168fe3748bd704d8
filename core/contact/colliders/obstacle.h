// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/collider.h"
#include "core/motion.h"

namespace sherd {

/// A collider that stands still or has a scripted motion; sheets and bodies cannot push it away.
struct Obstacle : Collider {
    Motion motion;

    bool moves() const { return !motion.keys.empty(); }
};

}  // namespace sherd
