// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_obstacles.h"

#include <set>
#include <utility>

#include "app/files/plain_name.h"

namespace sherd {

std::vector<ExportObstacle> export_obstacles(const Recording& recording,
                                             std::span<const std::size_t> frames) {
    std::vector<ExportObstacle> obstacles;
    std::vector<RecordedObstacle> recorded = recording.obstacles();
    std::set<std::string> used;
    for (RecordedObstacle& obstacle : recorded)
        obstacles.push_back({plain_name("obstacle_" + obstacle.name, used), std::move(obstacle.surface),
                             obstacle.plane, obstacle.deforms && frames.size() > 1, obstacle.deforms});
    if (obstacles.empty()) return obstacles;
    const std::vector<Eigen::Isometry3d> first = recording.poses(frames.front());
    for (const std::size_t number : frames) {
        const std::vector<Eigen::Isometry3d> poses = recording.poses(number);
        for (std::size_t i = 0; i < obstacles.size(); ++i)
            obstacles[i].moves |= poses[i].matrix() != first[i].matrix();
    }
    return obstacles;
}

TriangleSheet placed(const GridSurface& surface, const Eigen::Isometry3d& pose) {
    TriangleSheet sheet;
    for (const Vector3d& point : surface.points) sheet.points.push_back(pose * point);
    sheet.triangles = surface.triangles;
    return sheet;
}

}  // namespace sherd
