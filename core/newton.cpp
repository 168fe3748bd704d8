// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton.h"

#include <cmath>
#include <stdexcept>

namespace sherd {
namespace {

constexpr double sufficient_decrease = 1e-4;  // Armijo's constant
constexpr double flattening = 0.9;            // of the slope, where round-off hides the decrease of the value
constexpr int max_halvings = 40;

/// Of the way from the exact Hessian to the convex one, where the former is not positive definite. Of a sheet
/// that buckles the exact one lacks little, and the convex one, without all compression, is so much stiffer
/// that iterations creep.
constexpr double shares_of_convex[] = {0.25, 1};

/// Whether the matrix is positive definite.
bool has_factor(const IncrementalPotential& potential, NewtonSystem& system) {
    const Stopwatch watch(potential.time_spent(), Task::factorization);
    return system.solver.factorize(system.matrix);
}

void factorize(const IncrementalPotential& potential, NewtonSystem& system, const Positions& x) {
    if (!potential.fits(x, system.matrix)) {
        const Stopwatch watch(potential.time_spent(), Task::contact);
        system = NewtonSystem(potential, x);
    }
    potential.hessian(x, Curvature::exact, system.matrix);
    if (has_factor(potential, system)) return;
    const std::vector<double> exact(system.matrix.values().begin(), system.matrix.values().end());
    potential.hessian(x, Curvature::convex, system.matrix);
    const std::vector<double> convex(system.matrix.values().begin(), system.matrix.values().end());
    for (const double share : shares_of_convex) {
        system.matrix.blend(exact, convex, share);
        if (has_factor(potential, system)) return;
    }
    throw std::runtime_error(
        "Newton's method: the convex Hessian is not positive definite (NaN in the positions?)");
}

Positions newton_direction(const IncrementalPotential& potential, NewtonSystem& system,
                           const Positions& gradient) {
    const Stopwatch watch(potential.time_spent(), Task::solution);
    return system.solver.solve(-gradient.reshaped()).reshaped(3, gradient.cols());
}

/// Moves x along `direction`, as far as nothing is met, halving it until the potential decreases. The value
/// has a round-off error that is large beside the last decreases: a step after which the slope is flatter is
/// good too.
bool line_search(const IncrementalPotential& potential, const Positions& direction, double slope,
                 Positions& x) {
    double scale = potential.safe_fraction(x, direction);
    if (scale == 0) return false;
    const double start = potential.value(x), round_off = potential.round_off() + 1e-12 * std::abs(start);
    if (-slope <= round_off) {  // nothing could be told of a shorter step
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

NewtonResult minimise(const IncrementalPotential& potential, NewtonSystem& system,
                      const NewtonOptions& options, Positions& x) {
    NewtonResult result;
    while (result.iterations < options.max_iterations) {
        const Positions gradient = potential.gradient(x);
        factorize(potential, system, x);
        ++result.iterations;
        const Positions direction = newton_direction(potential, system, gradient);
        result.correction = direction.cwiseAbs().maxCoeff();
        const bool moved = line_search(potential, direction, gradient.cwiseProduct(direction).sum(), x);
        result.converged = result.correction <= options.tolerance;
        if (result.converged || !moved) break;
    }
    return result;
}

}  // namespace sherd
