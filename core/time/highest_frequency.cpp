// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/highest_frequency.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/shell/supports.h"

namespace sherd {
namespace {

/// Length of trial displacements over the shortest edge: differences of forces then have a relative error of
/// about 1e-5.
constexpr double trial = 1e-5;
/// Share of noise in each starting vector, so that modes that a crack has created are found.
constexpr double noise = 0.05;
/// Largest residual, over the eigenvalue (the square of the frequency).
constexpr double tolerance = 0.03;
constexpr Eigen::Index basis = 8, max_restarts = 200;

double shortest_edge(const Shell& shell) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i)
            shortest = std::min(shortest, (shell.rest.col(triangle.vertices[i]) -
                                           shell.rest.col(triangle.vertices[(i + 1) % 3]))
                                              .norm());
    return shortest;
}

void start(const Shell& shell, Positions& mode) {
    if (mode.cols() != shell.mass.size()) mode = Positions::Zero(3, shell.mass.size());
    std::mt19937 random(1);
    const double scale = mode.isZero(0) ? 1 : noise * mode.cwiseAbs().maxCoeff();
    for (double& entry : mode.reshaped())
        entry += scale * (static_cast<double>(random()) / std::mt19937::max() - 0.5);
    constrain(shell, mode);
}

/// Operator M^-1/2 K M^-1/2 on displacements times M^1/2, with the interface that Spectra requires.
struct StiffnessMap {
    using Scalar = double;

    const std::function<Positions(const Positions&)>& gradient;
    const Shell& shell;
    const Positions& x;
    double length;  ///< m, of trial displacements
    VectorXd root = shell.mass.cwiseSqrt().cwiseInverse();
    Positions at_x = gradient(x);

    Eigen::Index rows() const { return x.size(); }
    Eigen::Index cols() const { return x.size(); }
    void perform_op(const double* in, double* out) const {
        Positions moved = Eigen::Map<const Positions>(in, 3, x.cols()) * root.asDiagonal();
        // Where few vertices are free the method restarts from vectors that move fixed vertices, too.
        constrain(shell, moved);
        if (!moved.isZero(0)) {
            const double scale = length / moved.cwiseAbs().maxCoeff();
            moved = (gradient(x + scale * moved) - at_x) / scale * root.asDiagonal();
            constrain(shell, moved);
        }
        Eigen::Map<Positions>(out, 3, x.cols()) = moved;
    }
};

}  // namespace

double highest_frequency(const std::function<Positions(const Positions&)>& gradient, const Shell& shell,
                         const Positions& x, Positions& mode) {
    start(shell, mode);
    if (mode.isZero(0)) return 0;
    StiffnessMap map{gradient, shell, x, trial * shortest_edge(shell)};
    const Positions begin = mode * shell.mass.cwiseSqrt().asDiagonal();
    Spectra::SymEigsSolver<StiffnessMap> solver(map, 1, std::min(basis, map.rows()));
    solver.init(begin.data());
    solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw std::runtime_error(
            "explicit steps: the highest frequency, which limits the substep, cannot be computed; sherd "
            "check warns of implausible materials and triangles, and implicit steps do not need this "
            "frequency");
    mode = solver.eigenvectors().reshaped(3, x.cols()) * map.root.asDiagonal();
    return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

Index fastest_triangle(const Shell& shell, const Positions& mode) {
    const VectorXd energy = shell.mass.cwiseProduct(mode.colwise().squaredNorm().transpose());
    const auto sum = [&](const TriangleStencil& triangle) {
        return energy[triangle.vertices[0]] + energy[triangle.vertices[1]] + energy[triangle.vertices[2]];
    };
    return static_cast<Index>(std::ranges::max_element(shell.triangles, {}, sum) - shell.triangles.begin());
}

}  // namespace sherd
