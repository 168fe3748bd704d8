// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/built_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "app/scene/build/body_start.h"
#include "app/scene/build/contact_pairs.h"
#include "app/scene/build/gauges.h"
#include "app/scene/build/loads.h"
#include "app/scene/build/obstacle_start.h"
#include "app/scene/build/obstacles.h"
#include "app/scene/build/score.h"
#include "app/scene/build/sheet.h"
#include "app/scene/build/sheet_separation.h"
#include "app/scene/build/supports.h"
#include "app/scene/build/thickness.h"
#include "app/scene/build/winds.h"
#include "app/scene/build/yield_message.h"
#include "core/time/stability.h"
#include "meshops/error.h"

namespace sherd {
namespace {

void require_stability(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all) {
    const auto stable = [&](const BreakableShell& sheets) {
        return stable_at_rest(sheets.mechanics(), scene.simulation.stepper.shell.bending.model,
                              scene.simulation.stepper.shell.membrane);
    };
    if (stable(all)) return;
    std::vector<std::string> mistakes;
    // Each sheet is tested alone, to name those that are unstable.
    for (std::size_t s = 0; s < inputs.size(); ++s)
        if (!stable(BreakableShell({inputs[s]})))
            mistakes.push_back(fmt::format(
                "{}: a sheet {} m thick does not hold this shape: where edges are shorter than the "
                "thickness, bending outweighs stretching and the thin-shell model does not apply; make "
                "the edges longer (edge_length, or remesh on a mesh file) or the thickness smaller",
                scene.sheets[s].where, thickness_text(inputs[s])));
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

/// Adds the scene's obstacles and bodies. If a sheet overlaps one at the start, throws Error or, where the
/// scene exempts overlaps, adds a warning.
void add_obstacles(const Scene& scene, BuiltScene& built, std::vector<std::string>& warnings) {
    ContactOptions& contact = built.options.stepper.contact;
    const ThicknessRange sheets = thickness_range(built.inputs);
    contact.obstacles = make_obstacles(scene.obstacles, sheets, warnings, scene.bodies);
    contact.bodies = make_bodies(scene, sheets);
    require_free_bodies(scene, contact.obstacles, contact.bodies);
    const std::vector<Obstacle> bodies = make_obstacles(scene.bodies, sheets, warnings);
    require_free_start(scene, built.inputs, built.sheets, scene.obstacles, contact.obstacles, warnings);
    require_free_start(scene, built.inputs, built.sheets, scene.bodies, bodies, warnings);
    if (!scene.exempts_overlaps) return;
    const std::size_t first = contact.obstacles.size(), count = first + bodies.size();
    exempt_sheet_overlaps(built.inputs, contact.obstacles, 0, count, built.sheets);
    exempt_sheet_overlaps(built.inputs, bodies, first, count, built.sheets);
}

}  // namespace

BuiltScene build_scene(const Scene& scene, std::vector<SheetInput> inputs,
                       std::vector<std::string>& warnings) {
    require_few_pairs(scene, inputs);
    BreakableShell all(inputs);
    BuiltScene built{std::move(inputs), std::move(all), scene.simulation};
    built.options.stepper.shell.yields = plastic_yields(scene);
    require_stability(scene, built.inputs, built.sheets);
    separate_overlapping_sheets(scene, built.inputs, built.sheets, warnings);
    add_obstacles(scene, built, warnings);
    add_supports(scene, built.inputs, built.sheets.mechanics(), built.options);
    add_loads(scene, built.inputs, built.sheets.mechanics(), built.options);
    add_gauges(scene, built.sheets.mechanics(), built.options);
    add_winds(scene, built.sheets.mechanics(), built.options);
    built.options.cracks = cracked_edges(scene, built.inputs);
    return built;
}

BuiltScene build_scene(const Scene& scene, std::vector<std::string>& warnings) {
    std::vector<SheetInput> inputs;
    for (const SheetSpec& sheet : scene.sheets) inputs.push_back(make_sheet(sheet, scene, warnings));
    return build_scene(scene, std::move(inputs), warnings);
}

}  // namespace sherd
