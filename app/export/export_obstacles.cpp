// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_obstacles.h"

#include <fmt/format.h>

#include <cctype>
#include <set>
#include <utility>

namespace sherd {
namespace {

/// A name without what a file's name or a line of an OBJ cannot have in it. Bytes of UTF-8 stay.
std::string plain(std::string name) {
    for (char& letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x80 && !std::isalnum(code) && letter != '-' && letter != '.') letter = '_';
    }
    return name;
}

/// Names that differ before they are plain differ afterwards, too.
std::string unused(const std::string& name, std::set<std::string>& used) {
    std::string found = name;
    for (int number = 2; !used.insert(found).second; ++number) found = fmt::format("{}_{}", name, number);
    return found;
}

}  // namespace

std::vector<ExportObstacle> export_obstacles(const Recording& recording,
                                             std::span<const std::size_t> frames) {
    std::vector<ExportObstacle> obstacles;
    std::vector<RecordedObstacle> recorded = recording.obstacles();
    std::set<std::string> used;
    for (RecordedObstacle& obstacle : recorded)
        obstacles.push_back({unused("obstacle_" + plain(obstacle.name), used), std::move(obstacle.surface),
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
