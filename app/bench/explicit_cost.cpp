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
constexpr int steps = 60;         // of which the fastest counts
/// What coupled hinges read and write in a substep: 400 bytes for each face, 200 for each of its hinges and
/// 360 for each vertex.
constexpr std::size_t bytes_a_face = 400 + 200 * 3 / 2 + 360 / 2;

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

ExplicitCost explicit_cost(const std::string& model, int threads) {
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(parse_scene(scene_of(model), "bench", {}), warnings);
    built.options.stepper.threads = threads;
    Simulation simulation(std::move(built.sheets), built.options);
    for (int i = 0; i < steps_before; ++i) simulation.step();
    ExplicitCost cost;
    cost.faces = simulation.shell().mechanics().triangles.size();
    const auto step = [&] { cost.substeps += simulation.step().newton_iterations; };
    cost.step = threads == 1 ? least_seconds(steps, step) : least_wall_seconds(steps, step);
    cost.substeps /= steps;
    return cost;
}

double explicit_bound(std::size_t faces) {
    const std::size_t length = faces * bytes_a_face / (3 * sizeof(double));
    std::vector<double> sum(length, 0), one(length, 1), other(length, 2);
    const double seconds = least_wall_seconds(steps, [&] {
        for (std::size_t i = 0; i < length; ++i) sum[i] = one[i] + sum[0] * other[i];
    });
    return static_cast<double>(faces) / seconds;
}

}  // namespace sherd
