// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/point_contacts.h"

namespace sherd {

std::vector<PointContact> point_contacts(const std::vector<RigidBody>& bodies, std::size_t obstacles) {
    std::vector<PointContact> all;
    for (std::size_t body = 0; body < bodies.size(); ++body)
        for (std::size_t other = 0; other < bodies.size() + obstacles; ++other) {
            // The centre of a ball finds all contacts of the ball, so that the corners of a box, or the
            // centre of a second ball, must not find them again.
            const bool found_by_other =
                other < bodies.size() && is_ball(bodies[other]) && (!is_ball(bodies[body]) || other < body);
            if (body == other || found_by_other) continue;
            for (const Vector3d& point : bodies[body].contact_points) all.push_back({body, other, point});
        }
    return all;
}

}  // namespace sherd
