// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double deepest_start = 0.25, noticed = 1e-3;  // of the thickness

/// The vertices of one sheet that touch one obstacle at the start.
struct InsideObstacle {
    std::size_t count = 0;
    Vertex deepest;
    double depth = 0;  ///< m, from where they touch on
};

InsideObstacle inside(const SheetInput& input, const Obstacle& obstacle) {
    InsideObstacle found;
    const Eigen::Isometry3d pose = obstacle.motion.at(0);
    for (const Vertex v : input.mesh.vertices()) {
        if (std::binary_search(input.pinned.begin(), input.pinned.end(), static_cast<Index>(v.idx())))
            continue;
        const double thickness = input.material.thickness;
        const double depth = overlap(*obstacle.shape, pose, position(input.mesh, v), 0.5 * thickness).depth;
        found.count += depth > noticed * thickness;
        if (depth <= found.depth) continue;
        found.depth = depth;
        found.deepest = v;
    }
    return found;
}

std::string message(const SheetSpec& sheet, const SheetInput& input, const ObstacleSpec& obstacle,
                    const InsideObstacle& found) {
    const Vector3d at = position(input.mesh, found.deepest);
    return fmt::format(
        "{}: {} of {} vertices of sheet.{} start inside, vertex {} at [{:.4g}, {:.4g}, {:.4g}] the deepest, "
        "{:.3g} m beyond touching: move the sheet or the obstacle by that much, or make it smaller",
        obstacle.where, found.count, input.mesh.number_of_vertices(), sheet.name, found.deepest.idx(), at.x(),
        at.y(), at.z(), found.depth);
}

}  // namespace

void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings) {
    std::vector<std::string> mistakes;
    for (std::size_t s = 0; s < inputs.size(); ++s)
        for (std::size_t o = 0; o < obstacles.size(); ++o) {
            const InsideObstacle found = inside(inputs[s], obstacles[o]);
            if (found.count == 0) continue;
            const bool deep = found.depth > deepest_start * inputs[s].material.thickness;
            (deep ? mistakes : warnings).push_back(message(scene.sheets[s], inputs[s], specs[o], found));
        }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace sherd
