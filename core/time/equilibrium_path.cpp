// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/equilibrium_path.h"

#include <cmath>

#include "core/shell/supports.h"

namespace sherd {
namespace {

/// Newton's method on a path converges within few iterations or not at all. If it does not, the step is too
/// long.
constexpr int most_iterations = 12;

void set_load(double load, std::span<Energy* const> loads, StepContext& step) {
    step.load = load;
    for (Energy* energy : loads) energy->begin(step);
}

}  // namespace

void EquilibriumPath::begin(double length_of_step, StepContext& step) {
    length = length_of_step;
    predicted = at_last_load = false;
    step.load = start_load;
}

double EquilibriumPath::product(const Positions& a, const Positions& b) const {
    return (a.cwiseProduct(b).colwise().sum() * shell.mass).value() / shell.mass.sum();
}

double EquilibriumPath::distance(const Positions& displacement) const {
    return std::sqrt(product(displacement, displacement));
}

Positions EquilibriumPath::tangent(Potential& potential, std::span<Energy* const> loads, StepContext& step,
                                   const Positions& x) {
    const double load = step.load;
    set_load(1, loads, step);
    Positions force = Positions::Zero(3, x.cols());
    for (const Energy* energy : loads) energy->add_gradient(x, force);
    constrain(shell, force);
    set_load(load, loads, step);
    return system.solve(potential, -force);
}

void EquilibriumPath::predict(Potential& potential, std::span<Energy* const> loads, StepContext& step,
                              Positions& x) {
    system.factorize(potential, x);
    const Positions along = tangent(potential, loads, step, x);
    const double speed = distance(along);
    if (scale == 0) scale = speed;
    const bool onwards = direction.cols() == 0 || product(along, direction) >= 0;
    const double change = (onwards ? length : -length) * scale / speed;
    x += change * along;
    set_load(start_load + change, loads, step);
    predicted = true;
}

bool EquilibriumPath::correct(const Positions& moved, const Positions& to_equilibrium,
                              const Positions& tangent, Correction& correction) const {
    // correction.load solves |moved + to_equilibrium + load * tangent| = length * scale. With the solution
    // that is taken the path turns less than with the other solution.
    const Positions there = moved + to_equilibrium;
    const double a = product(tangent, tangent), b = product(there, tangent),
                 c = product(there, there) - std::pow(length * scale, 2);
    const double root = b * b - a * c;
    if (!(root >= 0)) return false;
    const double ahead = product(tangent, moved);
    correction.load = (-b + (ahead >= 0 ? 1 : -1) * std::sqrt(root)) / a;
    correction.motion = to_equilibrium + correction.load * tangent;
    return true;
}

bool EquilibriumPath::passed(StepContext& step, std::span<Energy* const> loads, Positions& x) {
    if (at_last_load || (step.load - last_load) * (start_load - last_load) > 0) return false;
    const double share = (last_load - start_load) / (step.load - start_load);
    x = shell.position + share * (x - shell.position);
    set_load(last_load, loads, step);
    return at_last_load = true;
}

MinimiserResult EquilibriumPath::solve(Potential& potential, std::span<Energy* const> loads,
                                       StepContext& step, int max_iterations, Positions& x) {
    MinimiserResult result;
    if (!predicted) predict(potential, loads, step, x);
    int since = 0;  // number of iterations since the call, or since the last load was reached
    while (result.iterations < max_iterations && since < most_iterations) {
        system.factorize(potential, x);
        ++result.iterations;
        ++since;
        const Positions to_equilibrium = system.solve(potential, -potential.gradient(x));
        Correction correction{to_equilibrium, 0};
        if (!at_last_load &&
            !correct(x - shell.position, to_equilibrium, tangent(potential, loads, step, x), correction))
            break;
        const double scale_of_motion = potential.safe_fraction(x, correction.motion);
        x += scale_of_motion * correction.motion;
        if (!at_last_load) set_load(step.load + scale_of_motion * correction.load, loads, step);
        result.correction = correction.motion.cwiseAbs().maxCoeff();
        result.converged = result.correction <= tolerance;
        if (!result.converged) continue;
        if (!passed(step, loads, x)) break;
        result.converged = false;
        since = 0;
    }
    return result;
}

void EquilibriumPath::topology_changed(const ShellChange& change, const Potential& potential,
                                       const Positions& x) {
    if (direction.cols() > 0) follow(direction, change);
    system.topology_changed(change, potential, x);
}

void EquilibriumPath::finish(const StepContext& step, const Positions& x) {
    direction = x - shell.position;
    start_load = step.load;
}

}  // namespace sherd
