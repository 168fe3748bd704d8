// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/built_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/scene/assemble/gauges.h"
#include "app/scene/assemble/obstacle/obstacles.h"
#include "app/scene/assemble/sheet/score.h"
#include "app/scene/assemble/sheet/selection.h"
#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/assemble/sheet/thickness.h"
#include "app/scene/assemble/start/contact_pairs.h"
#include "app/scene/assemble/start/obstacle_start.h"
#include "app/scene/assemble/start/sheet_separation.h"
#include "app/scene/assemble/winds.h"
#include "app/scene/assemble/yield_message.h"
#include "app/scene/scene.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/time/stability.h"
#include "fracture/step/simulation.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<Index> numbers_of(const std::vector<char>& selected) {
    std::vector<Index> numbers;
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v)
        if (selected[v]) numbers.push_back(v);
    return numbers;
}

std::vector<Index> selected_triangles(const Shell& mechanics, const std::vector<char>& selected) {
    std::vector<Index> triangles;
    for (Index t = 0; t < static_cast<Index>(mechanics.triangles.size()); ++t) {
        const std::array<Index, 3>& v = mechanics.triangles[t].vertices;
        if (selected[v[0]] && selected[v[1]] && selected[v[2]]) triangles.push_back(t);
    }
    return triangles;
}

/// Adds the scene's loads to the options. mechanics: of all inputs. Throws Error, naming the scene's line and
/// key, on a load that acts on nothing.
void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
               SimulationOptions& options) {
    for (const LoadSpec& spec : scene.loads) {
        const std::vector<char> selected = selected_vertices(spec.on, spec.sheet, scene, inputs);
        Load load;
        load.ramp = spec.ramp;
        if (spec.kind == "point")
            load.dead = point_forces(mechanics, numbers_of(selected), spec.force);
        else if (spec.kind == "line")
            load.dead = line_forces(mechanics, boundary_triangle_edges(mechanics, selected), spec.force);
        else if (spec.kind == "area")
            load.spread = area_forces(mechanics, selected_triangles(mechanics, selected), spec.force);
        else if (spec.kind == "moment")
            load.moments = edge_moments(mechanics, boundary_triangle_edges(mechanics, selected), spec.moment);
        else
            load.pressed = selected_triangles(mechanics, selected);
        load.pressure = spec.pressure;
        if (load.dead.empty() && load.spread.empty() && load.pressed.empty() && load.moments.empty())
            throw Error(fmt::format(
                "{}: acts on nothing: {} must be in its box, boundary or group", spec.where,
                spec.kind == "point"                           ? "a vertex"
                : spec.kind == "line" || spec.kind == "moment" ? "both ends of an edge of the boundary"
                                                               : "all vertices of a face"));
        options.stepper.shell.loads.push_back(load);
    }
}

/// Share of a body's size: an overlap below it is round-off, as of a body that is placed on a plane.
constexpr double placement_rounding = 1e-6;

/// Returns the overlap, m, of a body with a shape whose pose is `there`, at the body's deepest contact point;
/// negative if they do not overlap by more than round-off.
double depth(const RigidBody& body, const Shape& shape, const Eigen::Isometry3d& there) {
    double deepest = -1;
    for (const Vector3d& foot : body.contact_points)
        deepest = std::max(deepest, overlap(shape, there, body.pose() * foot, body.contact_radius).depth);
    const double size = body.shape->bounds().diagonal().norm();
    return deepest > placement_rounding * size ? deepest : -1;
}

std::string message(const ObstacleSpec& body, const ObstacleSpec& other, double depth) {
    return fmt::format("{}: starts {:.3g} m inside obstacle.{}: move one of them by that much", body.where,
                       depth, other.name);
}

/// Throws Error, with the scene's lines and keys, if a free body overlaps an obstacle or another body at the
/// start: contact springs would fling it out. obstacles, bodies: made from the scene's, in its order.
void require_free_bodies(const Scene& scene, const std::vector<Obstacle>& obstacles,
                         const std::vector<RigidBody>& bodies) {
    std::vector<std::string> mistakes;
    const auto check_pair = [&](const ObstacleSpec& body, const ObstacleSpec& other, double deep) {
        if (deep > 0) mistakes.push_back(message(body, other, deep));
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        for (std::size_t o = 0; o < obstacles.size(); ++o)
            check_pair(scene.bodies[b], scene.obstacles[o],
                       depth(bodies[b], *obstacles[o].shape, obstacles[o].motion.at(0)));
        for (std::size_t c = 0; c < b; ++c)
            check_pair(scene.bodies[b], scene.bodies[c],
                       std::max(depth(bodies[b], *bodies[c].shape, bodies[c].pose()),
                                depth(bodies[c], *bodies[b].shape, bodies[b].pose())));
    }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

void require_stability(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all) {
    const auto stable = [&](const BreakableShell& sheets) {
        return stable_at_rest(sheets.mechanics(), scene.simulation.stepper.shell.bending.model,
                              scene.simulation.stepper.shell.membrane);
    };
    if (stable(all)) return;
    std::vector<std::string> mistakes;
    // Each sheet is tested alone, so that the message names the unstable ones.
    for (std::size_t s = 0; s < inputs.size(); ++s)
        if (!stable(BreakableShell({inputs[s]})))
            mistakes.push_back(fmt::format(
                "{}: a sheet {} m thick does not hold this shape: where edges are shorter than the "
                "thickness, bending outweighs stretching and the thin-shell model does not apply; make "
                "the edges longer (edge_length, or remesh on a mesh file) or the thickness smaller",
                scene.sheets[s].where, thickness_text(inputs[s])));
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

/// Adds the scene's obstacles and free bodies to the options. If a sheet overlaps one of them too much at the
/// start, throws Error or, if Scene::exempts_overlaps is set, exempts the overlap and adds a warning.
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
