// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/scene_simulation.h"

#include <fmt/format.h>

#include <cmath>

#include "app/scene/build/body_start.h"
#include "app/scene/build/loads.h"
#include "app/scene/build/material_axes.h"
#include "app/scene/build/mesh.h"
#include "app/scene/build/obstacle_start.h"
#include "app/scene/build/obstacles.h"
#include "app/scene/build/strength.h"
#include "app/scene/build/supports.h"
#include "app/scene/build/winds.h"
#include "core/time/stability.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

void require_stability(const SheetInput& input, const SheetSpec& sheet, BendingModel bending) {
    if (stable_at_rest(BreakableSheet({input}).mechanics(), bending)) return;
    throw Error(
        fmt::format("{}: a sheet {} m thick does not hold this shape: where edges are shorter than the "
                    "thickness, bending outweighs stretching and the thin-shell model does not apply; make "
                    "the edges longer (edge_length, or remesh on a mesh file) or the thickness smaller",
                    sheet.where, input.material.thickness));
}

/// The paper's limit of validity, section 8.
void warn_of_stretching(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const double edge = measure(input.mesh).mean_edge, ratio = stretch_over_bend(input.material, edge);
    if (ratio >= least_stretch_over_bend) return;
    warnings.push_back(fmt::format(
        "{}: stretching stiffness Y t is {:.3g} times the hinges' bending stiffness lambda / L^2 (edges of "
        "L = {:.3g} m, thickness t = {:.3g} m); thin-shell bending wants {:.0f}: make the edges {:.2g} m or "
        "longer",
        sheet.where, ratio, edge, input.material.thickness, least_stretch_over_bend,
        edge * std::sqrt(least_stretch_over_bend / ratio)));
}

}  // namespace

SheetInput make_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings) {
    SheetInput input;
    input.mesh = make_mesh(sheet, scene, warnings);
    input.pinned = pinned_vertices(sheet, input.mesh);
    input.moving_pins = moving_pins(sheet, input.mesh);
    input.material = sheet.material;
    std::vector<std::string> axis_warnings;
    std::vector<Vector3d> axes = material_axes(sheet.axis, input.mesh, sheet.place, axis_warnings);
    const bool directed =
        !is_isotropic(sheet.material) ||
        (sheet.fracture && sheet.fracture->strength.along != sheet.fracture->strength.across);
    if (directed) {
        input.axes = std::move(axes);
        warnings.insert(warnings.end(), axis_warnings.begin(), axis_warnings.end());
    }
    warn_of_stretching(input, sheet, warnings);
    if (sheet.fracture) input.strength = sheet_strength(sheet, scene, input.mesh, warnings);
    input.velocity = sheet.velocity;
    input.spin = sheet.spin;
    require_stability(input, sheet, scene.solver.bending.model);
    return input;
}

SimulationOptions simulation_options(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     std::vector<std::string>& warnings) {
    SimulationOptions options;
    options.stepper.step = scene.solver.step;
    options.stepper.gravity = scene.gravity;
    options.stepper.shell.bending = scene.solver.bending;
    options.max_iterations = scene.solver.max_iterations;
    options.tolerance = scene.solver.tolerance;
    options.rule = scene.solver.rule;
    options.max_stages = scene.solver.max_stages;
    options.stepper.shell.damping = scene.solver.damping;
    options.stepper.contact.sheets = scene.contact.sheets;
    options.stepper.contact.friction = scene.contact.friction;
    options.stepper.contact.obstacles = make_obstacles(scene, scene.obstacles, warnings);
    options.stepper.contact.bodies = make_bodies(scene);
    require_free_bodies(scene, options.stepper.contact.obstacles, options.stepper.contact.bodies);
    require_free_start(scene, inputs, scene.obstacles, options.stepper.contact.obstacles, warnings);
    require_free_start(scene, inputs, scene.bodies, make_obstacles(scene, scene.bodies, warnings), warnings);
    const BreakableSheet all(inputs);
    add_supports(scene, inputs, all.mechanics(), options);
    add_loads(scene, inputs, all.mechanics(), options);
    add_winds(scene, all.mechanics(), options);
    return options;
}

}  // namespace sherd
