// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/solver.h"

#include <algorithm>

namespace sherd {
namespace {

constexpr double static_step = 0.05;  // load factor, default step of statics, in which a shell should turn by
                                      // some degrees only
constexpr Range from_1{.least = 1, .with_least = true};

constexpr std::array<std::string_view, 5> scheme_names{"implicit-euler", "bdf2", "auto", "explicit",
                                                       "static"};
constexpr std::array schemes{Scheme::implicit_euler, Scheme::bdf2, Scheme::implicit_euler,
                             Scheme::explicit_differences, Scheme::statics};
constexpr std::array<std::string_view, 2> methods{"quasi-newton", "newton"},
    membranes{"constant-strain", "arc"}, rules{"staged", "paper"};
constexpr std::array<std::string_view, 4> bendings{"coupled", "cubic", "cubic-2007", "nonlinear"};
constexpr std::array<std::string_view, 3> jacobians{"constant", "cubic", "nonlinear"};

/// Reads the scheme, and sets the defaults that depend on the scheme.
void read_scheme(TomlTable& table, const KeyInfo& key, Scene& scene) {
    if (table.has(key.name) && !is_retired(table, key)) {
        const std::size_t chosen = table.choice_number(key.name, key.rules.choices);
        scene.simulation.stepper.scheme = schemes[chosen];
        scene.simulation.alternates = scheme_names[chosen] == "auto";
    }
    if (scene.simulation.stepper.scheme == Scheme::explicit_differences)
        scene.simulation.stepper.step = scene.simulation.explicit_step;
    // In statics the stiffness matrix changes more from step to step than in dynamics, since it has no
    // constant part from inertia. The default is therefore Newton's method.
    if (scene.simulation.stepper.scheme == Scheme::statics) scene.simulation.stepper.method = Method::newton;
}

void read_step(TomlTable& table, const KeyInfo& key, Scene& scene) {
    const bool statics = scene.simulation.stepper.scheme == Scheme::statics;
    if (statics) scene.simulation.stepper.step = std::min(static_step, scene.simulation.stepper.last_load);
    scene.simulation.stepper.step = table.number(key.name, statics ? "times the loads" : key.rules.unit,
                                                 key.rules.range, scene.simulation.stepper.step);
}

void read_bending(TomlTable& table, const KeyInfo& key, Scene& scene) {
    read_value(table, key, scene.simulation.stepper.shell.bending.model);
    scene.simulation.stepper.shell.bending.jacobian =
        exact_jacobian(scene.simulation.stepper.shell.bending.model);
}

void read_jacobian(TomlTable& table, const KeyInfo& key, Scene& scene) {
    if (!table.has(key.name)) return;
    auto& [model, jacobian] = scene.simulation.stepper.shell.bending;
    read_value(table, key, jacobian);
    if (model == BendingModel::coupled)
        table.report(key.name,
                     "is for one of the paper's models (bending = \"cubic\"): coupled hinges have one matrix "
                     "of their own");
    else if (jacobian == BendingJacobian::nonlinear && model != BendingModel::nonlinear)
        table.report(key.name,
                     "\"nonlinear\" needs bending = \"nonlinear\": a cubic hinge takes \"constant\" "
                     "or \"cubic\"");
}

void complete_solver(TomlTable& table, Scene& scene) {
    const bool statics = scene.simulation.stepper.scheme == Scheme::statics;
    if (scene.simulation.stepper.scheme == Scheme::explicit_differences)
        for (const char* key : {"method", "jacobian", "max_iterations", "tolerance", "max_stages"})
            if (table.has(key))
                table.report(key, "is for implicit steps and statics, not for scheme = \"explicit\"");
    if (!statics)
        for (const char* key : {"load", "arc_length", "longest_path", "until_crack"})
            if (table.has(key)) table.report(key, "is for scheme = \"static\"");
    if (statics && !scene.simulation.stepper.arc_length && table.has("longest_path"))
        table.report("longest_path", "is for arc_length = true");
}

constexpr std::array damping_keys{
    key<&Damping::stiffness>("stiffness", "resists changes of shape; conserves linear and angular momentum",
                             {.unit = "s", .range = not_negative}),
    key<&Damping::mass>("mass", "resists all motion, free fall and flight too: velocities decay at this rate",
                        {.unit = "1/s", .range = not_negative})};
constexpr Section<Damping> damping_section{"Damping", damping_keys};

constexpr std::array solver_keys{
    special_key(
        "scheme", Form::choice,
        "implicit or explicit steps, or either as needed (`\"auto\"`); or statics, with load instead of time",
        {.choices = scheme_names,
         .otherwise = "`\"implicit-euler\"`",
         .retired = {"midpoint", "\"bdf2\" is of second order, too"}},
        read_scheme),
    retired_key<Scene>("adaptive", "scheme = \"auto\" makes short steps where something strikes or breaks"),
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::last_load>(
        "load", "the load factor at which statics end", {.unit = "times the loads", .range = positive}),
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::arc_length>(
        "arc_length", "follow the path of equilibria, on which the load may fall"),
    key<&Scene::longest_path>(
        "longest_path", "with `arc_length`: end after this length of path, if `load` has not been reached",
        {.unit = "times the loads", .range = positive}),
    key<&Scene::simulation, &SimulationOptions::until_crack>(
        "until_crack",
        "statics end with the first crack, and find its load to within a thousandth of `step`"),
    special_key(
        "step", Form::number,
        "time step; a step that cannot be solved is halved, down to 1/1024 of this, and grows again later",
        {.unit = "s",
         .range = positive,
         .otherwise = "1e-4, at most `output.every`; 2e-6 with `\"explicit\"`; a load of 0.05 in statics"},
        read_step),
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::method>(
        "method", "minimiser that solves a step",
        {.choices = methods, .retired = {"newton-2026", "\"newton\" gives the same results in less time"}}),
    special_key("bending", Form::choice, "bending energy: coupled hinges, or one of the paper's",
                {.choices = bendings,
                 .otherwise = "`\"coupled\"`",
                 .retired = {"coupled-cubic", "\"coupled\" gives the same results"}},
                read_bending),
    special_key("jacobian", Form::choice, "for the paper's models: derivative in Newton's method",
                {.choices = jacobians, .otherwise = "that of `bending`"}, read_jacobian),
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::shell,
        &ShellEnergyOptions::membrane>("membrane", "membrane energy, of stretching", {.choices = membranes}),
    key<&Scene::simulation, &SimulationOptions::max_iterations>(
        "max_iterations",
        "Newton iterations before a step is halved; four of `\"quasi-newton\"` count as one",
        {.range = from_1}),
    key<&Scene::simulation, &SimulationOptions::tolerance>(
        "tolerance", "largest Newton correction at which a step counts as solved",
        {.unit = "mean edge lengths", .range = positive}),
    key<&Scene::simulation, &SimulationOptions::rule>("rule", "which overloaded hinges break",
                                                      {.choices = rules}),
    key<&Scene::simulation, &SimulationOptions::max_stages>(
        "max_stages", "largest number of stages in a step, with `\"staged\"`", {.range = from_1}),
    table_key<damping_section, &Scene::simulation, &SimulationOptions::stepper, &StepperOptions::shell,
              &ShellEnergyOptions::damping>(
        "damping", "energy lost to friction in the material, or to a surrounding medium",
        {.otherwise = "none"})};

}  // namespace

constinit const Section<Scene> solver_section{"Time steps and their solution", solver_keys, complete_solver};

}  // namespace sherd
