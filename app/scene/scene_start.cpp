// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "fracture/start_overlaps.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr std::size_t most_shown = 5;
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

/// "face 12 of sheet.plate"; faces of all sheets are numbered in the sheets' order.
std::string name_of(Index face, const Scene& scene, const BreakableSheet& all) {
    const auto of_face = all.face_sheet();
    const Index sheet = of_face[face];
    const auto first = std::find(of_face.begin(), of_face.end(), sheet) - of_face.begin();
    return fmt::format("face {} of sheet.{}", face - first, scene.sheets[sheet].name);
}

std::string sentence(const StartOverlap& overlap, const Scene& scene, const BreakableSheet& all) {
    const std::string a = name_of(overlap.faces[0], scene, all), b = name_of(overlap.faces[1], scene, all);
    if (overlap.crossing) return fmt::format("{} and {} cross or touch", a, b);
    return fmt::format("{} and {} are {:.3g} m apart, less than {:.3g} m", a, b, overlap.distance,
                       overlap.needed);
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

void require_sheets_apart(const Scene& scene, const BreakableSheet& all) {
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    if (overlaps.empty()) return;
    std::string text;
    for (std::size_t i = 0; i < std::min(most_shown, overlaps.size()); ++i)
        text += "\n  " + sentence(overlaps[i], scene, all);
    if (overlaps.size() > most_shown)
        text += fmt::format("\n  and {} pairs more", overlaps.size() - most_shown);
    throw Error(fmt::format(
        "{}: sheets do not start apart, with half their thickness on either side:{}\nmove the sheets, make "
        "them thinner, or set contact.sheets = false",
        scene.file.string(), text));
}

}  // namespace sherd
