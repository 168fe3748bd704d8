// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "app/scene/scene.h"

namespace sherd {

/// Cost of an iteration of Newton's method. Times are processor time of one thread, s: see least_seconds().
struct NewtonCost {
    std::size_t vertices = 0;
    /// Numbers per vertex in the whole Hessian, above and below its diagonal, and in its factor.
    double hessian_entries = 0, factor_entries = 0;
    /// s, for the gradient, for the assembly of the Hessian, for its factorization, and for the solution of
    /// one linear system with the factor.
    double gradient = 0, hessian = 0, factorization = 0, solution = 0;
    double iteration = 0;  ///< s, sum of these four times and of the time for an energy in the line search
    /// s, for the layout of a new matrix, as after a crack, and for the analysis of its pattern.
    double layout = 0, analysis = 0;
};

/// Measures an iteration at the initial positions of a scene. Its matrix is the Hessian of the elastic
/// energies and, unless the scene is static, of inertia.
NewtonCost newton_cost(const Scene& scene);

}  // namespace sherd
