// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/scene/read/fields.h"
#include "app/scene/read/forces.h"
#include "app/scene/read/gauges.h"
#include "app/scene/read/obstacle.h"
#include "app/scene/read/sheet.h"
#include "app/scene/read/statics.h"
#include "app/scene/read/variants.h"
#include "app/scene/toml/override.h"
#include "app/scene/toml/settings.h"
#include "app/scene/toml/toml_file.h"
#include "app/scene/toml/toml_table.h"
#include "app/words/nearest_name.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double most_steps = 1e9;  // decades of computing: a mistyped step, not a wish

BendingOptions read_bending(TomlTable& table) {
    constexpr std::array<std::string_view, 4> models{"coupled", "cubic", "cubic-2007", "nonlinear"};
    constexpr std::array<std::string_view, 3> jacobians{"constant", "cubic", "nonlinear"};
    BendingOptions bending;
    if (table.has("bending") &&
        !table.retired("bending", "coupled-cubic", "\"coupled\" gives the same results")) {
        const std::string model = table.choice("bending", models);
        if (model == "cubic") bending.model = BendingModel::cubic;
        if (model == "cubic-2007") bending.model = BendingModel::cubic_2007;
        if (model == "nonlinear") bending.model = BendingModel::nonlinear;
    }
    bending.jacobian = exact_jacobian(bending.model);
    if (table.has("jacobian")) {
        const std::string jacobian = table.choice("jacobian", jacobians);
        if (jacobian == "constant") bending.jacobian = BendingJacobian::constant;
        if (jacobian == "cubic") bending.jacobian = BendingJacobian::cubic;
        if (bending.model == BendingModel::coupled)
            table.report("jacobian",
                         "is for one of the paper's models (bending = \"cubic\"): coupled hinges have one "
                         "matrix of their own");
        else if (jacobian == "nonlinear" && bending.model != BendingModel::nonlinear)
            table.report("jacobian",
                         "\"nonlinear\" needs bending = \"nonlinear\": a cubic hinge takes \"constant\" "
                         "or \"cubic\"");
    }
    return bending;
}

Method read_method(TomlTable& table) {
    if (table.retired("method", "newton-2026", "\"newton\" gives the same results in less time"))
        return Method::newton;
    constexpr std::array<std::string_view, 2> names{"quasi-newton", "newton"};
    constexpr std::array methods{Method::quasi_newton, Method::newton};
    return methods[table.choice_number("method", names)];
}

ContactSpec read_contact(TomlTable& table) {
    ContactSpec contact;
    contact.sheets = table.flag("sheets", contact.sheets);
    if (table.has("start")) {
        constexpr std::array<std::string_view, 2> starts{"exempt", "error"};
        contact.exempt = table.choice("start", starts) == "exempt";
    }
    contact.friction = table.number("friction", "", not_negative, contact.friction);
    table.finish();
    return contact;
}

SolverSpec read_solver(TomlTable& table) {
    SolverSpec solver;
    constexpr int most = std::numeric_limits<int>::max();
    read_scheme(table, solver);
    if (table.has("method")) solver.method = read_method(table);
    solver.bending = read_bending(table);
    if (table.has("membrane")) {
        constexpr std::array<std::string_view, 2> models{"constant-strain", "arc"};
        if (table.choice("membrane", models) == "arc") solver.membrane = MembraneModel::arc;
    }
    solver.max_iterations = static_cast<int>(table.integer("max_iterations", 1, most, solver.max_iterations));
    solver.tolerance = table.number("tolerance", "mean edge lengths", positive, solver.tolerance);
    if (table.has("rule")) {
        constexpr std::array<std::string_view, 2> rules{"staged", "paper"};
        if (table.choice("rule", rules) == "paper") solver.rule = BreakingRule::paper;
    }
    solver.max_stages = static_cast<int>(table.integer("max_stages", 1, most, solver.max_stages));
    if (auto damping = table.table("damping")) {
        solver.damping.stiffness = damping->number("stiffness", "s", not_negative, 0);
        solver.damping.mass = damping->number("mass", "1/s", not_negative, 0);
        damping->finish();
    }
    table.finish();
    return solver;
}

void read_duration(TomlTable& root, Scene& scene) {
    if (!scene.is_static()) {
        scene.duration = root.number("duration", "s", positive);
        return;
    }
    if (root.has("duration")) root.report("duration", "is not for statics, which end at solver.load");
    scene.duration = scene.solver.arc_length ? scene.solver.longest_path : scene.solver.load;
}

void require_few_steps(const Scene& scene, TomlTable& table, const char* key, const char* advice) {
    const double steps = scene.duration / scene.solver.step;
    if (steps > most_steps)
        table.report(key,
                     fmt::format("would take {:.2g} steps, more than {:.0g}: {}", steps, most_steps, advice));
}

/// Frames are recorded at the ends of steps: a step that the scene does not give is no longer than the time
/// between two frames.
void read_frame_interval(TomlTable& output, bool step_is_given, Scene& scene) {
    scene.frame_interval = output.number("every", "s", positive, scene.frame_interval);
    if (scene.frame_interval >= scene.solver.step) return;
    if (step_is_given || scene.is_static())
        return output.report(
            "every", fmt::format("is shorter than solver.step ({} s), at whose ends frames are recorded",
                                 scene.solver.step));
    scene.solver.step = scene.frame_interval;
    require_few_steps(scene, output, "every", "give a longer one");
}

void read_times(TomlTable& root, Scene& scene) {
    auto solver = root.table("solver");
    if (solver) scene.solver = read_solver(*solver);
    read_duration(root, scene);
    if (solver && scene.solver.step > scene.duration)
        solver->report("step", fmt::format("is longer than {} ({} {})",
                                           !scene.is_static()        ? "duration"
                                           : scene.solver.arc_length ? "longest_path"
                                                                     : "load",
                                           scene.duration, scene.time_unit()));
    if (solver && solver->has("step"))
        require_few_steps(scene, *solver, "step", "give a longer one");
    else if (root.has("duration"))
        require_few_steps(scene, root, "duration", "give a shorter one, or a longer solver.step");
    scene.frame_interval = std::max(scene.is_static() ? 0 : scene.duration / 100, scene.solver.step);
    if (auto output = root.table("output")) {
        if (output->has("every")) read_frame_interval(*output, solver && solver->has("step"), scene);
        scene.fields = read_fields(*output);
        scene.checkpoint_interval =
            output->number("checkpoint", "s", not_negative, scene.checkpoint_interval);
        output->finish();
    }
}

/// The paper's rule breaks what is over its strength, and nothing else counts.
void require_paper(TomlTable& root, const FractureSpec& fracture) {
    if (fracture.has_toughness())
        root.report("solver", "rule = \"paper\" knows no toughness: leave one of them out");
    if (fracture.art_direction.smallest > 0)
        root.report("solver", "rule = \"paper\" knows no fracture.smallest: leave one of them out");
}

void read_sheets(TomlTable& root, Scene& scene) {
    if (auto sheets = root.table("sheet")) {
        for (auto& [name, table] : sheets->entries())
            scene.sheets.push_back(read_sheet(name, table, scene.file.parent_path()));
    } else if (root.has("sheet")) {
        return;  // reported as no table
    }
    for (const SheetSpec& sheet : scene.sheets)
        if (sheet.fracture && scene.solver.rule == BreakingRule::paper) require_paper(root, *sheet.fracture);
    // Plates have one rigidity; only how hinges stand for it is a choice.
    for (const SheetSpec& sheet : scene.sheets)
        if (scene.solver.bending.model == BendingModel::coupled &&
            sheet.material.calibration == Calibration::paper)
            root.report("sheet",
                        fmt::format("{}: its material's calibration = \"paper\" is for the paper's "
                                    "bending models: add solver.bending = \"cubic\", or leave it out",
                                    sheet.name));
    if (scene.sheets.empty())
        root.report("sheet", "the scene has no sheet: add [sheet.NAME] with mesh and material");
}

void read_root(TomlTable& root, Scene& scene) {
    read_times(root, scene);
    scene.seed = root.integer("seed", 0, std::numeric_limits<std::uint32_t>::max(), scene.seed);
    read_sheets(root, scene);
    if (auto obstacles = root.table("obstacle"))
        for (auto& [name, table] : obstacles->entries()) {
            const ObstacleSpec obstacle = read_obstacle(name, table, scene.file.parent_path());
            (obstacle.free ? scene.bodies : scene.obstacles).push_back(obstacle);
        }
    if (auto contact = root.table("contact")) scene.contact = read_contact(*contact);
    if (auto force = root.table("force")) read_forces(*force, scene);
    read_gauges(root, scene);
    if (scene.is_static()) require_statics(root, scene);
    if (root.has("variant"))
        root.report("variant",
                    "has its place in the scene itself only: a variant has none, and --set cannot make one");
    root.finish();
}

void choose_variant(toml::table& document, const Scene& scene, Problems& problems) {
    TomlTable root(document, "", problems);
    const std::vector<std::string> names = read_variant_names(root);
    if (!scene.variant.empty() && std::find(names.begin(), names.end(), scene.variant) == names.end()) {
        const std::string nearest = nearest_name(scene.variant, names);
        throw Error(fmt::format(
            "--variant {}: {} has no variant of this name; {}{}", scene.variant, scene.file.string(),
            nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest),
            names.empty() ? "it has no variants at all" : fmt::format("it has: {}", fmt::join(names, ", "))));
    }
    apply_variant(document, scene.variant);
}

}  // namespace

std::string read_scene_text(const std::filesystem::path& file) {
    return read_toml_text(file, "scene");
}

std::vector<std::string> variant_names(const std::string& text, const std::filesystem::path& file) {
    const toml::table document = parse_toml(text, file);
    Problems problems;
    TomlTable root(document, "", problems);
    std::vector<std::string> names = read_variant_names(root);
    problems.throw_if_any();
    return names;
}

Scene read_scene(const std::filesystem::path& file, const SceneChoice& choice) {
    return parse_scene(read_scene_text(file), file, choice);
}

Scene parse_scene(std::string text, const std::filesystem::path& file, const SceneChoice& choice,
                  GivenMeshes meshes) {
    Scene scene;
    scene.given_meshes = std::move(meshes);
    scene.file = file;
    scene.variant = choice.variant;
    toml::table document = parse_toml(text, file);
    scene.text = recorded_text(std::move(text), choice);
    Problems problems;
    choose_variant(document, scene, problems);
    for (const std::string& assignment : choice.overrides) apply_override(document, assignment);
    scene.settings = settings_of(document);
    TomlTable root(document, "", problems);
    read_root(root, scene);
    problems.throw_if_any();
    return scene;
}

}  // namespace sherd
