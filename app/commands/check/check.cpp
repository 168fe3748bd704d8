// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <numbers>
#include <utility>

#include "app/commands/check/fault_picture.h"
#include "app/commands/commands.h"
#include "app/commands/run_cost.h"
#include "app/messages/counted.h"
#include "app/messages/place_text.h"
#include "app/messages/print.h"
#include "app/progress/idle_timer.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/crack_step_message.h"
#include "app/scene/assemble/check/own_weight.h"
#include "app/scene/assemble/check/plausibility.h"
#include "app/scene/assemble/check/squeeze.h"
#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/assemble/sheet/thickness.h"
#include "app/scene/assemble/yield_message.h"
#include "app/scene/read/variant_remarks.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/components.h"

namespace sherd {
namespace {

/// The command line of `sherd check`.
struct CheckOptions {
    SceneOptions scene;
    bool no_try = false;
    std::filesystem::path faults = {};  ///< PLY file in which faulty faces are coloured; empty: none
    bool force = false;
};

void print_factors(const std::vector<double>& factors) {
    const auto range = factor_range(factors);
    if (range) print_result("  times {:.3g} to {:.3g}, edge by edge", range->least, range->most);
    if (range && range->never > 0)
        print_result("; {} never {}", counted(range->never, "edge"), range->never == 1 ? "breaks" : "break");
    if (range) print_result("\n");
    if (!range && !factors.empty()) print_result("  no edge ever breaks\n");
}

void print_strength(const SheetSpec& sheet, const SheetInput& input) {
    const Strength& strength = input.strength;
    if (!sheet.fracture) {
        print_result("  does not break\n");
        return;
    }
    const auto words = [&](double value) {
        if (strength.measure == Measure::stress)
            return fmt::format("{:.4g} Pa of tension at its surface", value);
        const double thin = value * input.thinnest() / 2, thick = value * input.thickest() / 2;
        return fmt::format("{:.4g} 1/m, {:.3g}{} of strain at its surface", value, thin,
                           thick > thin ? fmt::format(" to {:.3g}", thick) : "");
    };
    if (strength.along == strength.across)
        print_result("  breaks above {}\n", words(strength.along));
    else
        print_result("  breaks above {} along its axis, {} across\n", words(strength.along),
                     words(strength.across));
    print_factors(strength.factors);
    if (sheet.material.tempered > 0)
        print_result("  and {:.4g} Pa more, the compression of its surfaces\n", sheet.material.tempered);
}

void print_toughness(const Toughness& toughness) {
    if (!toughness.given()) return;
    if (toughness.has_directions())
        print_result("  cracks propagate above {:.4g} Pa m^0.5 along its axis, {:.4g} across,",
                     toughness.value, *toughness.across);
    else
        print_result("  cracks propagate above {:.4g} Pa m^0.5,", toughness.value);
    print_result(" at {:.4g} m/s at most\n", toughness.speed_limit);
    print_factors(toughness.factors);
}

SheetInput print_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings) {
    std::string remeshed;
    SheetInput input = make_sheet(sheet, scene, warnings, &remeshed);
    const Mesh& mesh = input.mesh;
    const MeshMeasures m = measure(mesh);
    print_result("sheet {}\n", sheet.name);
    const std::size_t partly = partly_pinned_vertices(sheet, mesh);
    print_result("  vertices {}, faces {}, components {}, boundary loops {}, pinned vertices {}{}\n",
                 mesh.number_of_vertices(), mesh.number_of_faces(), connected_components(mesh).count,
                 m.boundary_loops, input.pinned.size(), partly > 0 ? fmt::format(", partly {}", partly) : "");
    print_result("  area {:.6g} m^2, mass {:.6g} kg\n", m.area,
                 m.area * input.material.thickness * input.material.density);
    if (!input.thickness.empty())
        print_result("  thickness {} m, {:.3g} m on average\n", thickness_text(input),
                     input.material.thickness);
    print_result("  box {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g} m\n", m.lower.x(), m.lower.y(),
                 m.lower.z(), m.upper.x(), m.upper.y(), m.upper.z());
    print_result("  edges {:.4g} m on average, {:.4g} to {:.4g} m; smallest angle {:.3g} degrees\n",
                 m.mean_edge, m.smallest_edge, m.largest_edge, m.smallest_angle * 180 / std::numbers::pi);
    if (!remeshed.empty()) print_result("  {}\n", remeshed);
    print_strength(sheet, input);
    print_toughness(input.toughness);
    return input;
}

void print_bodies(const Scene& scene, const std::vector<RigidBody>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody& body = bodies[b];
        print_result(
            "free obstacle {}\n  mass {:.6g} kg, centre of mass {}, inertia {:.4g}, {:.4g}, {:.4g} kg m^2\n",
            scene.bodies[b].name, body.mass, place_text(body.centre), body.inertia.x(), body.inertia.y(),
            body.inertia.z());
    }
}

void print_cost(const Scene& scene, BuiltScene built, const CheckOptions& options,
                std::vector<std::string>& warnings) {
    RunCost cost = run_cost(scene, built);
    if (!options.no_try && cost.memory < cost.machine_memory) {
        warn_of_own_weight(scene, built.inputs, warnings);
        const IdleTimer long_first_step(std::chrono::seconds(10), [] {
            print_message(
                "sherd: still computing the first steps, for an estimate of the time; --no-try skips them\n");
        });
        const TriedSteps tried = try_steps(scene, std::move(built));
        add(cost, tried);
        if (!tried.failure.empty())
            warnings.push_back(fmt::format("{}: {}", scene.file.string(), tried.failure));
        if (tried.peaks.peak_yield > 1 && !bends_plastically(scene, scene.sheets[tried.peaks.yielding.sheet]))
            warnings.push_back(
                fmt::format("{}: stress reaches {} within {} steps; real metal would keep a dent, "
                            "here it springs back",
                            scene.file.string(),
                            yield_message(tried.peaks.peak_yield, tried.peaks.yielding, scene), tried.count));
    }
    print_result("{}", cost_lines(cost));
    warn_of_cost(scene, cost, warnings);
}

/// Throws Error if obstacles will squeeze a sheet, and adds a warning if they might.
void require_room_between(const Scene& scene, const BuiltScene& built, std::vector<std::string>& warnings) {
    const SqueezedSheets squeezed =
        squeezed_sheets(scene, built.inputs, built.options.stepper.contact.obstacles);
    warnings.insert(warnings.end(), squeezed.possible.begin(), squeezed.possible.end());
    if (!squeezed.certain.empty()) throw Error(fmt::format("{}", fmt::join(squeezed.certain, "\n")));
}

/// Prints a summary of the scene. Throws Error with all mistakes that show only when meshes are made.
void check(const Scene& scene, const CheckOptions& options, std::vector<std::string>& warnings) {
    if (!scene.variant.empty()) print_result("variant {}\n", scene.variant);
    if (!scene.is_static())
        print_result("{}: {:.6g} s in {} of {:.3g} s, a frame every {:.3g} s\n", scene.file.string(),
                     scene.duration, counted(step_count(scene), "step"), scene.simulation.stepper.step,
                     scene.frame_interval);
    else
        print_result("{}: statics to load {:.6g}{} in {} of {:.3g}, a frame every {:.3g}\n",
                     scene.file.string(), scene.simulation.stepper.last_load,
                     scene.simulation.stepper.arc_length ? " or along a path," : "",
                     counted(step_count(scene), "step"), scene.simulation.stepper.step, scene.frame_interval);
    std::vector<std::string> mistakes;
    std::vector<SheetInput> inputs;
    for (const SheetSpec& sheet : scene.sheets) {
        try {
            inputs.push_back(print_sheet(sheet, scene, warnings));
        } catch (const Error& error) {
            mistakes.emplace_back(error.what());
        }
    }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
    // Throws Error if a sheet overlaps or is unstable at rest, or if a load or a support acts on nothing.
    BuiltScene built = build_scene(scene, std::move(inputs), warnings);
    require_room_between(scene, built, warnings);
    print_bodies(scene, built.options.stepper.contact.bodies);
    if (const std::string words = crack_step_message(scene, built.sheets); !words.empty())
        print_result("cracks run {}\n", words);
    warn_of_implausible(scene, built.inputs, built.options, warnings);
    print_cost(scene, std::move(built), options, warnings);
}

/// Checks all variants. Prints their summaries, then all warnings, and throws Error with all mistakes.
int check_all(const CheckOptions& options) {
    VariantRemarks warnings, mistakes;
    const std::vector<Scene> scenes = read_scenes(options.scene);
    if (!options.faults.empty())
        for (const Scene& scene : scenes)
            require_fault_file(scene, part_file(options.faults, scene.variant), options.force);
    for (const Scene& scene : scenes) {
        std::vector<std::string> found;
        std::string mistake;
        try {
            check(scene, options, found);
        } catch (const Error& error) {
            mistake = error.what();
        }
        warnings.add(scene.variant, fmt::format("{}", fmt::join(found, "\n")));
        mistakes.add(scene.variant, mistake);
        if (!options.faults.empty())
            write_fault_picture(scene, part_file(options.faults, scene.variant), options.force);
    }
    for (const std::string& line : warnings.lines()) print_result("warning: {}\n", line);
    mistakes.throw_if_any();
    return 0;
}

}  // namespace

void add_check(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "check", "Report errors and likely mistakes of a scene, and estimate what its run will cost");
    auto options = std::make_shared<CheckOptions>();
    add_scene_options(*command, options->scene);
    command->add_flag("--no-try", options->no_try,
                      "Skip the first steps, from which the time of a run is estimated");
    command
        ->add_option("-o,--output", options->faults,
                     "PLY file of the sheets, with faces coloured that are exempt from contact or keep the "
                     "scene from starting; for variants NAME.ply becomes NAME-VARIANT.ply")
        ->option_text("FAULTS.ply");
    command->add_flag("--force", options->force, "Replace FAULTS.ply if it exists");
    command->footer("Example:\n  sherd check plate_drop -o faults.ply");
    command->callback([&chosen, options] { chosen = [options] { return check_all(*options); }; });
}

}  // namespace sherd
