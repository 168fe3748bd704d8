// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "app/scene/scene.h"

namespace sherd {

/// Cost of an iteration of Newton's method, in processor time of one thread, s: see least_seconds().
struct NewtonCost {
    std::size_t vertices = 0;
    double hessian_entries = 0, factor_entries = 0;  ///< a vertex; of the whole symmetric Hessian
    double gradient = 0, hessian = 0, factorization = 0, solution = 0;
    double iteration = 0;             ///< all four, and an energy for the line search
    double layout = 0, analysis = 0;  ///< for a new matrix, as after a crack
};

/// Measures it on the elastic energies of a scene where it starts, and on inertia if the scene has time.
NewtonCost newton_cost(const Scene& scene);

}  // namespace sherd
