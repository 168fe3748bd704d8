// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/newton.h"

#include <cmath>
#include <stdexcept>

namespace sherd {
namespace {

constexpr double sufficient_decrease = 1e-4;  // Armijo's constant
constexpr double flattening = 0.9;            // ratio of slopes accepted where round-off hides the decrease
constexpr int max_halvings = 40;

/// Shares of the way from the exact Hessian to the convex one that are tried when the exact one is not
/// positive definite. For a sheet that buckles the exact one is nearly definite, and the convex one, without
/// any compression, is so much stiffer that iterations progress slowly.
constexpr double shares_of_convex[] = {0.25, 1};

/// Moves x along `direction`, up to safe_fraction(), halving the step until the potential decreases. Since
/// round-off of the value is large compared with the last decreases, a step that flattens the slope is
/// accepted too.
bool line_search(const Potential& potential, const Positions& direction, double slope, Positions& x) {
    double scale = potential.safe_fraction(x, direction);
    if (scale == 0) return false;
    const double start = potential.value(x), round_off = potential.round_off() + 1e-12 * std::abs(start);
    if (-slope <= round_off) {  // shorter steps could not be judged
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

void NewtonSystem::analyze(const Potential& potential, const Positions& x) {
    matrix = potential.hessian_pattern(x);
    const Stopwatch watch(potential.time_spent(), Task::analysis);
    solver->analyze(*matrix);
}

void NewtonSystem::topology_changed(const ShellChange&, const Potential& potential, const Positions& x) {
    analyze(potential, x);
}

bool NewtonSystem::has_factor(const Potential& potential) {
    const Stopwatch watch(potential.time_spent(), Task::factorization);
    return solver->factorize(*matrix);
}

void NewtonSystem::factorize(const Potential& potential, const Positions& x) {
    if (!matrix) analyze(potential, x);
    if (!potential.fits(x, *matrix)) {
        const Stopwatch watch(potential.time_spent(), Task::contact);
        analyze(potential, x);
    }
    potential.hessian(x, Curvature::exact, *matrix);
    if (has_factor(potential)) return;
    const std::vector<double> exact(matrix->values().begin(), matrix->values().end());
    potential.hessian(x, Curvature::convex, *matrix);
    const std::vector<double> convex(matrix->values().begin(), matrix->values().end());
    for (const double share : shares_of_convex) {
        matrix->blend(exact, convex, share);
        if (has_factor(potential)) return;
    }
    throw std::runtime_error(
        "Newton's method: the convex Hessian is not positive definite (NaN in the positions, or in statics a "
        "part that nothing holds?)");
}

Positions NewtonSystem::solve(const Potential& potential, const Positions& right_side) {
    const Stopwatch watch(potential.time_spent(), Task::solution);
    return solver->solve(right_side.reshaped()).reshaped(3, right_side.cols());
}

void NewtonSystem::visit_state(StateVisitor& visit) {
    auto& [matrix, solver] = *this;
    bool known = matrix.has_value();
    visit(known);
    if (visit.reads()) matrix.reset();
    if (!known) return;
    if (!matrix) matrix.emplace(0, std::vector<std::pair<Index, Index>>(), std::vector<char>());
    visit(*matrix);
    if (visit.reads()) solver->analyze(*matrix);
}

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
        potential.moved_to(x);
        const bool moved = line_search(potential, direction, gradient.cwiseProduct(direction).sum(), x);
        result.converged = result.correction <= tolerance;
        if (result.converged || !moved) break;
    }
    return result;
}

}  // namespace sherd
