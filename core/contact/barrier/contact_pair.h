// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/contact/barrier/barrier.h"
#include "core/contact/barrier/edge_mollifier.h"
#include "core/contact/geometry/distance.h"

namespace sherd {

/// Two elements of sheets that may touch.
struct ContactPair {
    PairKind kind;
    std::array<Index, 4> vertices;  ///< in the order of PairPositions
    double stiffness;               ///< N/m, of the column of sheet between them: see ContactSurface
    double touching;                ///< m, the distance of the middle surfaces from which on they push
    EdgeMollifier mollifier;        ///< idle for a vertex and a triangle
    double closest = 0.75;          ///< of the touching distance: they never come as near

    double minimum() const { return closest * touching; }  ///< m
    Barrier barrier() const { return {touching - minimum()}; }
};

/// m.
double distance(const ContactPair& pair, const PairPositions& x);

/// Energy, J: stiffness times mollifier times barrier of what the distance exceeds the minimum by.
double value(const ContactPair& pair, const PairPositions& x);
/// dE/dx, N, [3, 4]; without sum and without torque.
PairPositions gradient(const ContactPair& pair, const PairPositions& x);
/// d2E/dx2, N/m. `convex` gives a positive semidefinite matrix near it: the Gauss-Newton part, and of edges
/// that the mollifier touches the positive part.
PairHessian hessian(const ContactPair& pair, const PairPositions& x, bool convex);

}  // namespace sherd
