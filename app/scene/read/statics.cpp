// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sherd {
namespace {

constexpr double static_step = 0.05;  // of load factor: a step should turn a shell by some degrees only

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

void read_scheme(TomlTable& table, SolverSpec& solver) {
    constexpr std::array<std::string_view, 5> names{"implicit-euler", "bdf2", "auto", "explicit", "static"};
    constexpr std::array schemes{Scheme::implicit_euler, Scheme::bdf2, Scheme::implicit_euler,
                                 Scheme::explicit_differences, Scheme::statics};
    const bool is_retired = table.retired("scheme", "midpoint", "\"bdf2\" is of second order, too");
    if (table.has("scheme") && !is_retired) {
        const std::size_t chosen = table.choice_number("scheme", names);
        solver.scheme = schemes[chosen];
        solver.alternates = names[chosen] == "auto";
    }
    const bool statics = solver.scheme == Scheme::statics;
    const bool is_explicit = solver.scheme == Scheme::explicit_differences;
    if (is_explicit) solver.step = explicit_step;
    table.retired("adaptive", "scheme = \"auto\" makes short steps where something strikes or breaks");
    // A step of load changes the matrix more than one of time, and nothing of inertia is in it that stays.
    if (statics) solver.method = Method::newton;
    for (const char* key : {"method", "jacobian", "max_iterations", "tolerance", "max_stages"})
        if (is_explicit && table.has(key))
            table.report(key, "is for steps that are solved, not for scheme = \"explicit\"");
    solver.load = table.number("load", "times the loads", positive, solver.load);
    solver.arc_length = table.flag("arc_length", solver.arc_length);
    solver.longest_path = table.number("longest_path", "times the loads", positive, solver.longest_path);
    solver.until_crack = table.flag("until_crack", solver.until_crack);
    solver.step = statics
                      ? table.number("step", "times the loads", positive, std::min(static_step, solver.load))
                      : table.number("step", "s", positive, solver.step);
    for (const char* key : {"load", "arc_length", "longest_path", "until_crack"})
        if (!statics && table.has(key)) table.report(key, "is for scheme = \"static\"");
    if (statics && !solver.arc_length && table.has("longest_path"))
        table.report("longest_path", "is for arc_length = true");
}

void require_statics(TomlTable& root, const Scene& scene) {
    for (const SheetSpec& sheet : scene.sheets) require_static_sheet(root, sheet);
    if (!scene.bodies.empty())
        root.report("obstacle", fmt::format("{}: free obstacles are not for statics", scene.bodies[0].name));
    if (!scene.winds.empty()) root.report("force", "wind is not for statics");
    for (const LoadSpec& load : scene.loads)
        if (load.ramp > 0)
            root.report("force", "load.ramp is not for statics: all loads grow with the load factor");
    if (scene.solver.damping.stiffness > 0 || scene.solver.damping.mass > 0)
        root.report("solver", "damping is not for statics");
    if (scene.loads.empty() && scene.gravity.isZero(0) && scene.solver.arc_length)
        root.report("solver", "arc_length needs a load");
    const bool moves = std::ranges::any_of(scene.sheets,
                                           [](const SheetSpec& sheet) {
                                               return has_keys(sheet.pins) || has_keys(sheet.clamps);
                                           }) ||
                       std::ranges::any_of(scene.obstacles, [](const ObstacleSpec& obstacle) {
                           return !obstacle.motion.keys.empty() || cache_of(obstacle) != nullptr;
                       });
    if (moves && scene.solver.arc_length)
        root.report("solver",
                    "arc_length is for loads: pins and obstacles that move need a load factor that "
                    "grows");
}

}  // namespace sherd
