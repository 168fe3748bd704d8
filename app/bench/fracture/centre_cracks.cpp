// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/bench/fracture/cracked_fields.h"
#include "app/bench/fracture/grown_crack.h"
#include "app/bench/shell/rim_load.h"
#include "core/tips/crack_direction.h"

namespace sherd {
namespace {

/// Theory's prediction for the scene, in which the crack is turned counterclockwise from the x axis.
struct CentreTheory {
    ModePair factors;  ///< Pa m^0.5, K_I and K_II at the load factor 1
    double turn;       ///< rad, angle by which the growing crack turns clockwise
    double load;       ///< load factor at which the crack grows

    explicit CentreTheory(const Scene& scene) {
        const FirstCrack crack(scene);
        const PulledSheet sheet(crack.half_length(), crack.angle());
        const double stress = pull(scene);
        factors = {stress * sheet.opening(), stress * sheet.shear()};
        turn = std::abs(hoop_angle(factors));
        const double c = std::cos(turn / 2);
        const double hoop = c * (factors.first * c * c + 1.5 * factors.second * std::sin(turn));
        load = scene.sheets.front().fracture->toughness / hoop;
    }
    static double pull(const Scene& scene) {
        return scene.loads.front().force.y() / scene.sheets.front().material.thickness;
    }
};

void pull_as_if_infinite(const Scene& scene, const Shell& shell, SimulationOptions& options) {
    const FirstCrack crack(scene);
    const PulledSheet sheet(crack.half_length(), crack.angle());
    const double force = scene.loads.front().force.y();
    Load load;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, on_bounding_rectangle(shell)))
        add_rim_stress(shell, side, force * sheet.stress(middle_of(shell, side)), load);
    options.stepper.shell.loads = {load};
}

/// The mean angle, degrees, by which the edges of the run's growth turn clockwise from the crack.
double mean_turn(const FractureHistory& run) {
    const FirstCrack crack(run.scene);
    const Vector2d ahead = (crack.to - crack.from).normalized();
    double sum = 0;
    const std::vector<GrownEdge> edges = grown_edges(run);
    for (const GrownEdge& edge : edges) {
        const Vector2d from = edge.from.dot(ahead) > 0 ? ahead : Vector2d(-ahead), way = edge.to - edge.from;
        sum += std::atan2(way.x() * from.y() - way.y() * from.x(), way.dot(from));
    }
    return sum / static_cast<double>(edges.size()) * 180 / std::numbers::pi;
}

std::vector<double> measure_centre(const FractureHistory& run) {
    const CentreTheory theory(run.scene);
    const double load = run.steps.back().load;
    double first = 0, second = 0;
    const std::vector<TipRecord> tips = last_tips(run);
    for (const TipRecord& tip : tips) {
        first += tip.opening / (load * static_cast<double>(tips.size()));
        second += std::abs(tip.shear) / (load * static_cast<double>(tips.size()));
    }
    const bool mixed = theory.factors.second > 1e-9 * theory.factors.first;
    return {first / theory.factors.first, second / (mixed ? theory.factors.second : first),
            load / theory.load, mean_turn(run) - theory.turn * 180 / std::numbers::pi};
}

FractureCase centre_crack(const std::string& degrees) {
    const bool mixed = degrees != "0";
    return {
        .name = fmt::format("centre crack at {} degrees", degrees),
        .scene = "experiments/centre_crack",
        .variant = degrees,
        .source =
            "an infinite sheet (Muskhelishvili 1953), whose stress pulls the rim, and the largest hoop "
            "stress (Erdogan and Sih 1963)",
        .unit = 0.02,
        .in_units = "a",
        .edges = {0.004, 0.0028, 0.002},
        .numbers = {{"K_I / theory", 1, 0.02},
                    mixed ? FractureNumber{"K_II / theory", 1, 0.02} : FractureNumber{"K_II / K_I", 0, 0.02},
                    {"load at growth / theory", 1, 0.05},
                    {"kink less theory's, degrees", 0, 3}},
        .measure = measure_centre,
        .replace_loads = pull_as_if_infinite};
}

}  // namespace

std::vector<FractureCase> centre_cracks() {
    return {centre_crack("0"), centre_crack("30"), centre_crack("60")};
}

}  // namespace sherd
