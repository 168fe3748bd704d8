// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/statics.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd {
namespace {

bool has_keys(const std::vector<PinSpec>& pins) {
    return std::ranges::any_of(pins, [](const PinSpec& pin) { return !pin.motion.keys.empty(); });
}

void require_static_sheet(TomlTable& root, const SheetSpec& sheet) {
    if (!sheet.velocity.isZero(0) || !sheet.spin.isZero(0))
        root.report("sheet", fmt::format("{}: velocity and spin are not for statics", sheet.name));
    if (!sheet.is_supported())
        root.report("sheet", fmt::format("{}: nothing holds it, and in statics it has no inertia: give it a "
                                         "pin, clamp or symmetry",
                                         sheet.name));
}

}  // namespace

void require_statics(TomlTable& root, const Scene& scene) {
    for (const SheetSpec& sheet : scene.sheets) require_static_sheet(root, sheet);
    if (!scene.bodies.empty())
        root.report("obstacle", fmt::format("{}: free obstacles are not for statics", scene.bodies[0].name));
    if (!scene.winds.empty()) root.report("force", "wind is not for statics");
    for (const LoadSpec& load : scene.loads)
        if (load.ramp > 0)
            root.report("force", "load.ramp is not for statics: all loads grow with the load factor");
    if (scene.simulation.stepper.shell.damping.stiffness > 0 ||
        scene.simulation.stepper.shell.damping.mass > 0)
        root.report("solver", "damping is not for statics");
    if (scene.loads.empty() && scene.simulation.stepper.gravity.isZero(0) &&
        scene.simulation.stepper.arc_length)
        root.report("solver", "arc_length needs a load");
    const bool moves = std::ranges::any_of(scene.sheets,
                                           [](const SheetSpec& sheet) {
                                               return has_keys(sheet.pins) || has_keys(sheet.clamps);
                                           }) ||
                       std::ranges::any_of(scene.obstacles, [](const ObstacleSpec& obstacle) {
                           return !obstacle.motion.keys.empty() || cache_of(obstacle) != nullptr;
                       });
    if (moves && scene.simulation.stepper.arc_length)
        root.report("solver",
                    "arc_length is for loads: pins and obstacles that move need a load factor that "
                    "grows");
}

}  // namespace sherd
