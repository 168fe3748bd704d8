// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/obstacle_track.h"

#include "core/contact/geometry/basic_shapes.h"

namespace sherd {
namespace {

GridSurface recorded_surface(const ColliderSurface& whole) {
    GridSurface surface;
    for (const auto& point : whole.points.colwise()) surface.points.push_back(point);
    surface.triangles = whole.triangles;
    return surface;
}

std::vector<Vector3d> points_of(const Obstacle& obstacle, double time) {
    const Positions points = obstacle.points_at(time);
    return {points.colwise().begin(), points.colwise().end()};
}

void extend(Eigen::AlignedBox3d& box, const ColliderSurface& surface, const Eigen::Isometry3d& pose) {
    for (const auto& point : surface.points.colwise()) box.extend(pose * Vector3d(point));
}

/// Returns the box around sheets, free bodies and all obstacles but planes.
Eigen::AlignedBox3d box_of(const Simulation& simulation) {
    const Positions& sheets = simulation.shell().mechanics().position;
    Eigen::AlignedBox3d box(sheets.rowwise().minCoeff(), sheets.rowwise().maxCoeff());
    for (const Obstacle& obstacle : simulation.obstacles())
        if (obstacle.deformation != nullptr)
            for (const Vector3d& point : points_of(obstacle, simulation.time())) box.extend(point);
        else if (obstacle.surface)
            extend(box, *obstacle.surface, obstacle.motion.at(simulation.time()));
    for (const RigidBody& body : simulation.bodies()) extend(box, *body.surface, body.pose());
    return box;
}

/// Returns a square in a plane, in the plane's own frame, around the point of the plane nearest to the box's
/// centre. Half the square's side is the box's diagonal. pose: from the plane's own frame to space.
GridSurface square(const PlaneShape& plane, const Eigen::Isometry3d& pose, const Eigen::AlignedBox3d& box) {
    const Vector3d way = pose.inverse() * box.center() - plane.point;
    const Vector3d middle = plane.point + (way - plane.normal.dot(way) * plane.normal);
    const Vector3d u = box.diagonal().norm() * plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
    return {{middle - u - v, middle + u - v, middle + u + v, middle - u + v}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace

Eigen::Isometry3d pose_of(const Obstacle& obstacle, double time) {
    return obstacle.deformation != nullptr ? Eigen::Isometry3d::Identity() : obstacle.motion.at(time);
}

ObstacleTrack::ObstacleTrack(const Scene& scene, const Simulation& simulation) {
    const std::vector<Obstacle>& obstacles = simulation.obstacles();
    const Eigen::AlignedBox3d box = box_of(simulation);
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const std::string& name = scene.obstacles[i].name;
        const Motion& motion = obstacles[i].motion;
        if (obstacles[i].deformation != nullptr) {
            GridSurface surface = recorded_surface(*obstacles[i].surface);
            surface.points = points_of(obstacles[i], simulation.time());
            recorded.push_back({.name = name, .surface = std::move(surface), .deforms = true});
        } else if (obstacles[i].surface)
            recorded.push_back({name, recorded_surface(*obstacles[i].surface)});
        else if (const auto* plane = dynamic_cast<const PlaneShape*>(obstacles[i].shape.get()))
            recorded.push_back({name, square(*plane, motion.at(simulation.time()), box), true});
        else
            continue;
        numbers.push_back(i);
    }
    const std::vector<RigidBody>& bodies = simulation.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        recorded.push_back({scene.bodies[i].name, recorded_surface(*bodies[i].surface)});
}

std::vector<Eigen::Isometry3d> ObstacleTrack::poses(const Simulation& simulation) const {
    std::vector<Eigen::Isometry3d> poses;
    for (const std::size_t number : numbers)
        poses.push_back(pose_of(simulation.obstacles()[number], simulation.time()));
    for (const RigidBody& body : simulation.bodies()) poses.push_back(body.pose());
    return poses;
}

ObstacleShapes ObstacleTrack::shapes(const Simulation& simulation) const {
    ObstacleShapes shapes(recorded.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (const Obstacle& obstacle = simulation.obstacles()[numbers[i]]; obstacle.deformation != nullptr)
            shapes[i] = points_of(obstacle, simulation.time());
    return shapes;
}

}  // namespace sherd
