// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "app/bench/fracture/grown_crack.h"

namespace sherd {
namespace {

/// Theory's K_I at the load factor 1, Pa m^0.5.
double notch_theory(const Scene& scene) {
    const std::array<Vector2d, 2> corners = outline_corners(scene);
    const double a = 2 * FirstCrack(scene).half_length(), x = a / (corners[1].x() - corners[0].x());
    const double stress = scene.loads.front().force.y() / scene.sheets.front().material.thickness;
    return stress * std::sqrt(std::numbers::pi * a) *
           (1.12 - 0.231 * x + 10.55 * x * x - 21.72 * std::pow(x, 3) + 30.39 * std::pow(x, 4));
}

std::vector<double> measure_notch(const FractureHistory& run) {
    const double theory = notch_theory(run.scene), load = run.steps.back().load;
    return {last_tips(run).front().opening / (load * theory),
            load * theory / run.scene.sheets.front().fracture->toughness};
}

}  // namespace

FractureCase edge_notch() {
    return {.name = "edge notch, a / W = 0.4",
            .scene = "experiments/edge_notch",
            .variant = "",
            .source = "Tada, Paris and Irwin's handbook (0.5 %)",
            .unit = 0.04,
            .in_units = "a",
            .edges = {0.004, 0.002, 0.001},
            .numbers = {{"K_I / theory", 1, 0.02}, {"load at growth / theory", 1, 0.05}},
            .measure = measure_notch};
}

}  // namespace sherd
