// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/colliders/rigid_body.h"

namespace sherd {

/// A contact point of a body and another collider, whose shape it may touch. `body` and `other` are numbers
/// of colliders, bodies first, then obstacles.
struct PointContact {
    std::size_t body, other;
    Vector3d point;  ///< m, contact point in the body's frame
};

/// Whether the body is a ball, whose centre is its only contact point.
inline bool is_ball(const RigidBody& body) {
    return body.contact_points.size() == 1;
}

/// Returns all contacts that may occur, each once. obstacles: number of obstacles.
std::vector<PointContact> point_contacts(const std::vector<RigidBody>& bodies, std::size_t obstacles);

}  // namespace sherd
