// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/contact_colliders.h"

#include "core/contact/detection/near_surface.h"

namespace sherd {
namespace {

/// Pinned vertices that touch the surface of a deforming obstacle, which has no inside, at time 0.
std::vector<Index> held_at(const Shell& shell, const Obstacle& obstacle) {
    VectorXd reach = VectorXd::Constant(shell.position.cols(), -1);
    for (Index v = 0; v < static_cast<Index>(shell.fixed.size()); ++v)
        if (shell.fixed[v]) reach[v] = 0.5 * shell.thickness[v];
    return near_surface(obstacle.points_at(0), obstacle.surface->triangles, shell.position, reach);
}

/// Pinned vertices that touch an obstacle, or are inside it, at time 0.
std::vector<Index> held_inside(const Shell& shell, const Obstacle& obstacle) {
    if (obstacle.deformation != nullptr) return held_at(shell, obstacle);
    std::vector<Index> held;
    const Eigen::Isometry3d pose = obstacle.motion.at(0);
    for (Index v = 0; v < static_cast<Index>(shell.fixed.size()); ++v)
        if (shell.fixed[v] &&
            overlap(*obstacle.shape, pose, shell.position.col(v), 0.5 * shell.thickness[v]).depth > 0)
            held.push_back(v);
    return held;
}

}  // namespace

std::vector<ContactCollider> contact_colliders(const Shell& shell, const std::vector<Obstacle>& obstacles) {
    std::vector<ContactCollider> colliders;
    for (std::size_t o = 0; o < obstacles.size(); ++o)
        if (const Obstacle& obstacle = obstacles[o]; obstacle.surface)
            colliders.push_back({obstacle.surface.get(), obstacle.young, obstacle.friction,
                                 held_inside(shell, obstacle), o, obstacle.deformation != nullptr});
    return colliders;
}

std::vector<Index> first_vertices(const std::vector<Obstacle>& obstacles) {
    std::vector<Index> first;
    Index count = 0;
    for (const Obstacle& obstacle : obstacles) {
        first.push_back(count);
        if (obstacle.surface) count += obstacle.surface->size();
    }
    return first;
}

Positions collider_positions(const std::vector<Obstacle>& obstacles, double time) {
    Eigen::Index count = 0;
    for (const Obstacle& obstacle : obstacles)
        if (obstacle.surface) count += obstacle.surface->points.cols();
    Positions positions(3, count);
    count = 0;
    for (const Obstacle& obstacle : obstacles) {
        if (!obstacle.surface) continue;
        const Eigen::Index size = obstacle.surface->points.cols();
        positions.middleCols(count, size) = obstacle.points_at(time);
        count += size;
    }
    return positions;
}

}  // namespace sherd
