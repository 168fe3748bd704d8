// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/elastica.h"

#include <cmath>

namespace sherd {
namespace {

/// Angle, curvature, and the place along and across the cantilever.
using State = Eigen::Vector4d;

/// The tip's state if this is the curvature at the wall, by Runge-Kutta's method of fourth order.
State tip_state(double q, double curvature) {
    const auto slope = [&](double s, const State& y) {
        return State(y[1], -q * (1 - s) * std::cos(y[0]), std::cos(y[0]), std::sin(y[0]));
    };
    State y(0, curvature, 0, 0);
    constexpr int steps = 1000;
    constexpr double h = 1.0 / steps;
    for (int i = 0; i < steps; ++i) {
        const double s = i * h;
        const State a = slope(s, y), b = slope(s + h / 2, y + h / 2 * a), c = slope(s + h / 2, y + h / 2 * b),
                    d = slope(s + h, y + h * c);
        y += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return y;
}

}  // namespace

Vector2d elastica_tip(double q) {
    double low = 0, high = q;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (tip_state(q, middle)[1] < 0 ? low : high) = middle;
    }
    const State tip = tip_state(q, low);
    return {1 - tip[2], tip[3]};
}

}  // namespace sherd
