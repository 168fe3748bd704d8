// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/highest_frequency.h"

#include <cmath>
#include <random>

#include "core/shell/supports.h"

namespace sherd {
namespace {

/// Share of the shortest edge that the trial displacements have: differences of forces are then exact to
/// 1e-6.
constexpr double trial = 1e-5;
/// Share of noise that each start has, so that what a crack has made is found.
constexpr double noise = 0.05;

double shortest_edge(const Shell& shell) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i)
            shortest = std::min(shortest, (shell.rest.col(triangle.vertices[i]) -
                                           shell.rest.col(triangle.vertices[(i + 1) % 3]))
                                              .norm());
    return shortest;
}

Positions gradient(std::span<Energy* const> energies, const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    for (const Energy* energy : energies) energy->add_gradient(x, sum);
    return sum;
}

void start(const Shell& shell, Positions& mode) {
    if (mode.cols() != shell.mass.size()) mode = Positions::Zero(3, shell.mass.size());
    std::mt19937 random(1);
    const double scale = mode.isZero(0) ? 1 : noise * mode.cwiseAbs().maxCoeff();
    for (double& entry : mode.reshaped())
        entry += scale * (static_cast<double>(random()) / std::mt19937::max() - 0.5);
    constrain(shell, mode);
}

}  // namespace

double highest_frequency(std::span<Energy* const> energies, const Shell& shell, const Positions& x,
                         int iterations, Positions& mode) {
    start(shell, mode);
    const VectorXd lightness = shell.mass.cwiseInverse();
    const double length = trial * shortest_edge(shell);
    double squared = 0;
    for (int i = 0; i < iterations; ++i) {
        mode *= length / mode.cwiseAbs().maxCoeff();
        Positions next = (gradient(energies, x + mode) - gradient(energies, x - mode)) / 2;
        next *= lightness.asDiagonal();
        constrain(shell, next);
        const VectorXd before = mode.colwise().squaredNorm(), after = next.colwise().squaredNorm();
        squared = std::sqrt(after.dot(shell.mass) / before.dot(shell.mass));
        mode = next;
        if (squared == 0) break;
    }
    return std::sqrt(squared);
}

}  // namespace sherd
