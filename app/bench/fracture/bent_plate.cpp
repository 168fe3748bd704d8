// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "app/bench/fracture/cracked_fields.h"
#include "app/bench/fracture/grown_crack.h"
#include "app/bench/shell/rim_load.h"

namespace sherd {
namespace {

void bend_as_if_infinite(const Scene& scene, const Shell& shell, SimulationOptions& options) {
    const CrackedPlate plate(FirstCrack(scene).half_length(), scene.sheets.front().material.poisson);
    const double moment = scene.loads.front().moment;
    Load load;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, on_bounding_rectangle(shell))) {
        const Vector2d at = middle_of(shell, side);
        add_rim_moments(shell, side, moment * plate.moments(at), moment * plate.shear(at), load);
    }
    options.stepper.shell.loads = {load};
}

std::vector<double> measure_bent(const FractureHistory& run) {
    const SheetSpec& sheet = run.scene.sheets.front();
    const double t = sheet.material.thickness, nu = sheet.material.poisson, load = run.steps.back().load;
    const double unit =
        6 * run.scene.loads.front().moment / (t * t) * std::sqrt(FirstCrack(run.scene).half_length());
    const double needed = sheet.fracture->toughness * std::sqrt(3 * (3 + nu) / (std::numbers::pi * (1 + nu)));
    double first = 0;
    const std::vector<TipRecord> tips = last_tips(run);
    for (const TipRecord& tip : tips) first += std::abs(tip.bending) / static_cast<double>(tips.size());
    return {first / (load * unit), load * unit / needed};
}

}  // namespace

FractureCase bent_plate() {
    return {.name = "bent plate with a centre crack",
            .scene = "experiments/bent_plate",
            .variant = "",
            .source =
                "an infinite plate without shear, whose moments and forces bend the rim (Williams 1961, Hui "
                "and Zehnder 1993)",
            .unit = 0.02,
            .in_units = "a",
            .edges = {0.004, 0.002, 0.00133},
            .numbers = {{"k_1 / theory", 1, 0.02}, {"moment at growth / theory", 1, 0.05}},
            .measure = measure_bent,
            .replace_loads = bend_as_if_infinite};
}

}  // namespace sherd
