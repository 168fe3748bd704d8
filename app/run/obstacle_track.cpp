// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/obstacle_track.h"

namespace sherd {
namespace {

GridSurface recorded_surface(const ColliderSurface& whole) {
    GridSurface surface;
    for (const auto& point : whole.points.colwise()) surface.points.push_back(point);
    surface.triangles = whole.triangles;
    return surface;
}

}  // namespace

ObstacleTrack::ObstacleTrack(const Scene& scene, const Simulation& simulation) {
    const std::vector<Obstacle>& obstacles = simulation.obstacles();
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        if (obstacles[i].surface) {
            recorded.push_back({scene.obstacles[i].name, recorded_surface(*obstacles[i].surface)});
            motions.push_back(obstacles[i].motion);
        }
    const std::vector<RigidBody>& bodies = simulation.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        recorded.push_back({scene.bodies[i].name, recorded_surface(*bodies[i].surface)});
}

std::vector<Eigen::Isometry3d> ObstacleTrack::poses(const Simulation& simulation) const {
    std::vector<Eigen::Isometry3d> poses;
    for (const Motion& motion : motions) poses.push_back(motion.at(simulation.time()));
    for (const RigidBody& body : simulation.bodies()) poses.push_back(body.pose());
    return poses;
}

}  // namespace sherd
