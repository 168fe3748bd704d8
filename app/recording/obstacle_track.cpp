// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/obstacle_track.h"

#include "app/scene/obstacle_shape.h"

namespace sherd {

ObstacleTrack::ObstacleTrack(const Scene& scene, const std::vector<Obstacle>& made) {
    for (std::size_t i = 0; i < made.size(); ++i) {
        const ObstacleSpec& spec = scene.obstacles[i];
        GridSurface surface = obstacle_surface(spec, made[i]);
        if (surface.points.empty()) continue;
        recorded.push_back({spec.name, std::move(surface)});
        motions.push_back(spec.motion);
    }
    for (const ObstacleSpec& spec : scene.bodies) {
        GridSurface surface = obstacle_surface(spec, {});
        // A body's frame has its origin in the centre of mass.
        const Vector3d centre = spec.motion.place.inverse() * spec.motion.pivot;
        for (Vector3d& point : surface.points) point -= centre;
        recorded.push_back({spec.name, std::move(surface)});
    }
}

std::vector<Eigen::Isometry3d> ObstacleTrack::poses(const Simulation& simulation) const {
    std::vector<Eigen::Isometry3d> poses;
    for (const Motion& motion : motions) poses.push_back(motion.at(simulation.time()));
    for (const RigidBody& body : simulation.bodies()) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = body.rotation;
        pose.translation() = body.centre;
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace sherd
