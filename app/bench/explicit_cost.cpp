// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/explicit_cost.h"

#include <fmt/format.h>

#include "app/bench/shell_case.h"
#include "app/machine/processor_time.h"
#include "app/scene/build/built_scene.h"
#include "app/scene/read/scene.h"
#include "fracture/simulation.h"

namespace sherd {
namespace {

constexpr int steps_before = 10;  // until the disc is in contact
constexpr int steps = 20;         // in a round

std::string scene_of(const std::string& model) {
    const ShellVariant variant = shell_variant(model, 0, false);
    std::string text = R"(
duration = 1
[sheet.disc]
mesh = { generate = "plate", radius = 0.075, edge_length = 0.0027 }
place = { translate = [0, 0, 0.0006] }
velocity = [0, 0, -5]
material = { preset = "glass", thickness = 0.001 }
[obstacle.nose]
sphere = { centre = [0, 0, -0.01], radius = 0.01 }
[contact]
sheets = false
[solver]
scheme = "explicit"
)";
    text += fmt::format("bending = \"{}\"\n", variant.bending);
    if (!variant.membrane.empty()) text += fmt::format("membrane = \"{}\"\n", variant.membrane);
    return text;
}

}  // namespace

ExplicitCost explicit_cost(const std::string& model) {
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(parse_scene(scene_of(model), "bench", {}), warnings);
    Simulation simulation(std::move(built.sheets), built.options);
    for (int i = 0; i < steps_before; ++i) simulation.step();
    const Shell& shell = simulation.shell().mechanics();
    ExplicitCost cost;
    cost.faces = shell.triangles.size();
    cost.step = least_seconds([&] {
                    for (int i = 0; i < steps; ++i) cost.substeps += simulation.step().newton_iterations;
                }) /
                steps;
    cost.substeps /= rounds_of_least_seconds * steps;
    ShellEnergies energies(shell, built.options.stepper.shell);
    Positions gradient = Positions::Zero(3, shell.position.cols());
    cost.gradient = least_seconds([&] {
                        for (int i = 0; i < steps; ++i)
                            for (const Energy* energy : energies.elastic())
                                energy->add_gradient(shell.position, gradient);
                    }) /
                    steps;
    return cost;
}

}  // namespace sherd
