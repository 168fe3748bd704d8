// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/body_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double placement_rounding =
    1e-6;  // share of a body's size: less is round-off, as in placing on a plane

/// Depth, m, of the deepest of the body's contact points in a shape; negative if none is inside.
double depth(const RigidBody& body, const Shape& shape, const Eigen::Isometry3d& there) {
    double deepest = -1;
    for (const Vector3d& foot : body.contact_points)
        deepest = std::max(deepest, overlap(shape, there, body.pose() * foot, body.contact_radius).depth);
    const double size = body.shape->bounds().diagonal().norm();
    return deepest > placement_rounding * size ? deepest : -1;
}

std::string message(const ObstacleSpec& body, const ObstacleSpec& other, double depth) {
    return fmt::format("{}: starts {:.3g} m inside obstacle.{}: move one of them by that much", body.where,
                       depth, other.name);
}

}  // namespace

void require_free_bodies(const Scene& scene, const std::vector<Obstacle>& obstacles,
                         const std::vector<RigidBody>& bodies) {
    std::vector<std::string> mistakes;
    const auto check_pair = [&](const ObstacleSpec& body, const ObstacleSpec& other, double deep) {
        if (deep > 0) mistakes.push_back(message(body, other, deep));
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        for (std::size_t o = 0; o < obstacles.size(); ++o)
            check_pair(scene.bodies[b], scene.obstacles[o],
                       depth(bodies[b], *obstacles[o].shape, obstacles[o].motion.at(0)));
        for (std::size_t c = 0; c < b; ++c)
            check_pair(scene.bodies[b], scene.bodies[c],
                       std::max(depth(bodies[b], *bodies[c].shape, bodies[c].pose()),
                                depth(bodies[c], *bodies[b].shape, bodies[b].pose())));
    }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace sherd
