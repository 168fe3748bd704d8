// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/collider.h"
#include "core/deformation.h"
#include "core/motion.h"

namespace sherd {

/// A collider that stands still or has a scripted motion; sheets and bodies cannot push it away.
struct Obstacle : Collider {
    Motion motion;
    /// Motion of the surface's points relative to the obstacle's frame, which `motion` moves; null: the
    /// obstacle is rigid.
    std::shared_ptr<const Deformation> deformation = nullptr;

    bool moves() const {
        return !motion.keys.empty() || (deformation != nullptr && deformation->times.size() > 1);
    }
    /// Positions of the surface's points at `time` (s): [3, P] m.
    Positions points_at(double time) const {
        if (deformation != nullptr) return motion.at(time) * deformation->at(time);
        return motion.at(time) * surface->points;
    }
};

}  // namespace sherd
