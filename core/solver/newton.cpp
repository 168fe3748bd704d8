// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/newton.h"

#include <cmath>
#include <stdexcept>

namespace sherd {
namespace {

constexpr double sufficient_decrease = 1e-4;  // Armijo's constant
constexpr double flattening = 0.9;  // largest accepted ratio of slopes where round-off hides the decrease
constexpr int max_halvings = 40;

/// Moves x along `direction`, up to safe_fraction(), halving the step until the potential decreases. Near the
/// minimum round-off hides the decrease; there a step that reduces the slope is accepted, too. slope: J,
/// derivative of the potential along `direction` at x. Returns whether x has moved.
bool line_search(const Potential& potential, const Positions& direction, double slope, Positions& x) {
    double scale = potential.safe_fraction(x, direction);
    if (scale == 0) return false;
    const double start = potential.value(x), round_off = potential.round_off() + 1e-12 * std::abs(start);
    if (-slope <= round_off) {  // the decrease of shorter steps would be lost in round-off
        x += scale * direction;
        return true;
    }
    for (int halving = 0; halving < max_halvings; ++halving, scale /= 2) {
        const Positions trial = x + scale * direction;
        const double value = potential.value(trial);
        const bool decreases = value <= start + sufficient_decrease * scale * slope;
        const bool in_round_off = std::abs(value - start) <= round_off;
        if (decreases || (in_round_off && std::abs(potential.gradient(trial).cwiseProduct(direction).sum()) <=
                                              flattening * std::abs(slope))) {
            x = trial;
            return true;
        }
    }
    return false;
}

}  // namespace

void Newton::topology_changed(const ShellChange& change, const Potential& potential, const Positions& x) {
    system.topology_changed(change, potential, x);
}

MinimiserResult Newton::minimise(Potential& potential, int max_iterations, Positions& x) {
    MinimiserResult result;
    while (result.iterations < max_iterations) {
        const Positions gradient = potential.gradient(x);
        system.factorize(potential, x);
        ++result.iterations;
        const Positions direction = system.solve(potential, -gradient);
        result.correction = direction.cwiseAbs().maxCoeff();
        const bool moved = line_search(potential, direction, gradient.cwiseProduct(direction).sum(), x);
        result.converged = result.correction <= tolerance;
        if (result.converged || !moved) return result;
    }
    result.limited = true;
    return result;
}

}  // namespace sherd
