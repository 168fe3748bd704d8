// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/contact/barrier/barrier.h"
#include "core/contact/barrier/edge_mollifier.h"
#include "core/contact/geometry/distance.h"

namespace sherd {

/// Two elements of a contact surface that may touch.
struct ContactPair {
    PairKind kind;
    std::array<Index, 4> vertices;    ///< in the order of PairPositions
    double stiffness;                 ///< N/m, of the column of sheet between them (see ContactSurface)
    double activation_distance;       ///< m, activation distance of the middle surfaces
    EdgeMollifier mollifier;          ///< used by edge-edge pairs only
    double closest = 0.75;            ///< minimum distance, as a share of the activation distance
    bool spring = false;              ///< see Barrier
    SecondSpring second_spring = {};  ///< counts for springs only

    double minimum() const { return closest * activation_distance; }  ///< m
    Barrier barrier() const { return {activation_distance - minimum(), spring, second_spring}; }
    double largest_stiffness() const {
        return stiffness * (1 + second_spring.stiffness());
    }  ///< N/m, of a spring
};

/// Sorts pairs by their kind, then by their vertices.
void sort(std::vector<ContactPair>& pairs);

/// Distance of the two elements, m.
double distance(const ContactPair& pair, const PairPositions& x);
/// Whether the distance of the two elements is less than `limit`, m.
bool within(double limit, const ContactPair& pair, const PairPositions& x);

/// Energy, J: stiffness times mollifier times the barrier of the gap, which is the distance less the minimum.
double value(const ContactPair& pair, const PairPositions& x);
/// dE/dx, N, [3, 4]. Its columns sum to zero and exert no net torque.
PairPositions gradient(const ContactPair& pair, const PairPositions& x);
/// d2E/dx2, N/m. `convex` gives a positive semidefinite approximation: the Gauss-Newton part, and where the
/// mollifier of two edges is active, the projection to the positive semidefinite part.
PairHessian hessian(const ContactPair& pair, const PairPositions& x, bool convex);

}  // namespace sherd
