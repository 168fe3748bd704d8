// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/contact_solids.h"

namespace sherd {
namespace {

std::vector<Index> held_inside(const Sheet& sheet, const Obstacle& obstacle) {
    std::vector<Index> held;
    const Eigen::Isometry3d pose = obstacle.motion.at(0);
    for (Index v = 0; v < static_cast<Index>(sheet.fixed.size()); ++v)
        if (sheet.fixed[v] &&
            overlap(*obstacle.shape, pose, sheet.position.col(v), 0.5 * sheet.thickness[v]).depth > 0)
            held.push_back(v);
    return held;
}

}  // namespace

std::vector<ContactSolid> contact_solids(const Sheet& sheet, const std::vector<Obstacle>& obstacles) {
    std::vector<ContactSolid> solids;
    for (const Obstacle& obstacle : obstacles)
        if (obstacle.surface)
            solids.push_back(
                {obstacle.surface.get(), obstacle.young, obstacle.friction, held_inside(sheet, obstacle)});
    return solids;
}

Positions solid_positions(const std::vector<Obstacle>& obstacles, double time) {
    Eigen::Index count = 0;
    for (const Obstacle& obstacle : obstacles)
        if (obstacle.surface) count += obstacle.surface->points.cols();
    Positions positions(3, count);
    count = 0;
    for (const Obstacle& obstacle : obstacles) {
        if (!obstacle.surface) continue;
        const Eigen::Index size = obstacle.surface->points.cols();
        positions.middleCols(count, size) = obstacle.motion.at(time) * obstacle.surface->points;
        count += size;
    }
    return positions;
}

}  // namespace sherd
