// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/bench/fracture/grown_crack.h"

namespace sherd {
namespace {

constexpr double end_correction = 0.673;  // length by which arms exceed the crack, in heights of an arm

/// The strip of the scene, which the crack splits into two arms.
struct Cantilever {
    /// Height of one arm, m; Young's modulus, Pa; toughness, Pa m^0.5; thickness of the strip, m.
    double height, young, toughness, thickness;

    explicit Cantilever(const Scene& scene)
        : height(outline_corners(scene)[1].y()),
          young(scene.sheets.front().material.young),
          toughness(scene.sheets.front().fracture->toughness),
          thickness(scene.sheets.front().material.thickness) {}

    double release() const { return toughness * toughness / young; }
    /// Returns theory's length of the crack, m. opening: distance by which the ends of the two arms have
    /// moved apart, m; pressed: compressive stress along the arms, Pa. For the same opening this stress
    /// reduces the curvature at the root of an arm by the share x^2 / 15, with x^2 = pressed height t l^2 /
    /// (Y I) for an arm of length l, thickness t and second moment of area I.
    double crack(double opening, double pressed) const {
        const double plain =
            std::pow(3 * young * std::pow(height, 3) * opening * opening / (16 * release()), 0.25);
        const double x2 = 12 * pressed * plain * plain / (young * height * height);
        return plain * (1 - x2 / 30) - end_correction * height;
    }
};

/// The mean of the crack's length over theory's length, at the ends of steps from the first growth on.
double mean_length(const FractureHistory& run, const std::vector<GrownEdge>& edges) {
    const Cantilever strip(run.scene);
    const double press = run.scene.loads.front().force.x() / strip.thickness;
    double sum = 0, at = FirstCrack(run.scene).to.x();
    int count = 0;
    auto next = edges.begin();
    for (const StepReport& report : run.steps) {
        for (; next != edges.end() && next->step == report.step; ++next) at = next->to.x();
        if (next == edges.begin()) continue;
        sum += at / strip.crack(2 * report.gauges.front().displacement.y(), press * report.load);
        ++count;
    }
    return sum / count;
}

std::vector<double> measure_cantilever(const FractureHistory& run) {
    const Cantilever strip(run.scene);
    const std::vector<GrownEdge> edges = grown_edges(run);
    double length = 0, off = 0;
    for (const GrownEdge& edge : edges) {
        length += (edge.to - edge.from).norm();
        off = std::max(off, std::abs(edge.to.y()));
    }
    const double edge_length = std::get<GeneratedMesh>(run.scene.sheets.front().mesh).edge_length;
    return {mean_length(run, edges), off / edge_length,
            run.steps.back().lost_to_cracks / (strip.release() * strip.thickness * length)};
}

}  // namespace

FractureCase double_cantilever() {
    return {.name = "double cantilever",
            .scene = "experiments/double_cantilever",
            .variant = "",
            .source =
                "beams that are 0.673 of their height longer than the crack (Foote and Buchwald 1985; "
                "0.639 with Kanninen's foundation, 1973), pressed at their ends",
            .unit = 0.03,
            .in_units = "H",
            .edges = {0.005, 0.0035, 0.0025},
            .numbers = {{"crack length / theory", 1, 0.05},
                        {"farthest from the middle, edges", 0, 1},
                        {"energy taken / (G_c area)", 1, 0.15}},
            .measure = measure_cantilever};
}

}  // namespace sherd
