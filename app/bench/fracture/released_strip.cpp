// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/bench/fracture/fracture_case.h"

namespace sherd {
namespace {

constexpr double at_maximum = 3.5449077018110318;  // 2 sqrt(pi), where released_curvature() is largest

/// Curvature over the initial curvature, at the time t after one end of the strip is released and at the
/// distance s = x sqrt(c t) from this end. It is 2 S(x / sqrt(2 pi)) with Fresnel's integral S, or the
/// integral of sin(y^2 / 4) sqrt(2 / pi) over y from 0 to x, by Simpson's rule.
double released_curvature(double x) {
    constexpr int pieces = 200;
    const double h = x / pieces;
    double sum = 0;
    for (int i = 0; i <= pieces; ++i) {
        const double factor = i == 0 || i == pieces ? 1 : i % 2 == 1 ? 4 : 2;
        sum += factor * std::sin(i * i * h * h / 4);
    }
    return sum * h / 3 * std::sqrt(2 / std::numbers::pi);
}

/// The x at which the front of the largest wave reaches `curvature` times the initial curvature, as it comes
/// from larger x. The waves ahead of it reach only 1.258, 1.202 and less; `curvature` must be larger.
double place_of(double curvature) {
    double low = at_maximum, high = at_maximum * std::numbers::sqrt2;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (released_curvature(middle) > curvature ? low : high) = middle;
    }
    return low;
}

struct ReleasedStrip {
    double length;     ///< m
    double curvature;  ///< 1/m, initial curvature, before the release
    double stress;     ///< Pa, initial stress at the surface, before the release
    double speed;      ///< m^2/s, the constant c of released_curvature()

    explicit ReleasedStrip(const Scene& scene) {
        const SheetSpec& sheet = scene.sheets.front();
        const Material& material = sheet.material;
        length = std::get<GeneratedMesh>(sheet.mesh).width;
        curvature = sheet.bend->curvature;
        speed = material.thickness * std::sqrt(material.young / (12 * material.density));
        stress = material.young * material.thickness / 2 * curvature;
    }
};

double largest_curvature(const GaugeReading& gauge) {
    const Vector3d& k = gauge.curvature;
    return 0.5 * (k[0] + k[1] + std::hypot(k[0] - k[1], k[2]));
}

/// Largest principal curvature, 1/m, at gauge `g` at a time (s), interpolated between the ends of steps.
double curvature_at(const std::vector<StepReport>& steps, std::size_t g, double time) {
    const auto after = std::ranges::lower_bound(steps, time, {}, &StepReport::time);
    if (after == steps.begin()) return largest_curvature(after->gauges[g]);
    const auto before = std::prev(after == steps.end() ? std::prev(after) : after), next = std::next(before);
    const double share = (time - before->time) / (next->time - before->time);
    return (1 - share) * largest_curvature(before->gauges[g]) + share * largest_curvature(next->gauges[g]);
}

/// Returns the largest curvature over theory's, and the x of this curvature over theory's x. Curvature as a
/// function of x is the mean of all gauges, each at the time when it has this x: see released_curvature().
std::vector<double> measure_wave(const FractureHistory& run) {
    const ReleasedStrip strip(run.scene);
    double largest = 0, place = 0;
    for (double x = 2.5; x < 4.5; x += 0.01) {
        double mean = 0;
        for (std::size_t g = 0; g < run.scene.gauges.size(); ++g) {
            const double s = strip.length - run.scene.gauges[g].at.x();
            mean += curvature_at(run.steps, g, s * s / (strip.speed * x * x)) /
                    static_cast<double>(run.scene.gauges.size());
        }
        if (mean > largest) place = x;
        largest = std::max(largest, mean);
    }
    return {largest / (strip.curvature * released_curvature(at_maximum)), place / at_maximum};
}

/// Returns the time of the first failure over theory's time for the scored line, and the distance of this
/// failure from the released end over that of the line.
std::vector<double> measure_break(const FractureHistory& run) {
    if (run.events.failures.empty()) return {};
    const ReleasedStrip strip(run.scene);
    const FractureSpec& fracture = *run.scene.sheets.front().fracture;
    const Score& score = fracture.scores.front();
    const double s = strip.length - std::get<ScoreLine>(score.kind).points.front().x();
    const double x = place_of(fracture.strength.along * score.factor / strip.stress);
    const EdgeFailure& first = run.events.failures.front();
    const double at = strip.length - run.rest(0, first.vertices[0]);
    return {first.time / (s * s / (strip.speed * x * x)), at / s};
}

}  // namespace

std::vector<FractureCase> released_strips() {
    FractureCase wave{.name = "released strip",
                      .scene = "experiments/released_strip",
                      .variant = "whole",
                      .source = "a beam without end (Audoly and Neukirch 2005)",
                      .unit = 0.05,
                      .in_units = "s",
                      .edges = {0.006, 0.004, 0.003},
                      .numbers = {{"largest curvature / theory", 1, 0.02}, {"its place / theory", 1, 0.05}},
                      .measure = measure_wave,
                      .has_crack = false};
    FractureCase breaks = wave;
    breaks.name = "released strip with a scored line";
    breaks.variant = "scored";
    breaks.numbers = {{"time of the break / theory", 1, 0.05}, {"its place / the line's", 1, 0.01}};
    breaks.measure = measure_break;
    return {wave, breaks};
}

}  // namespace sherd
