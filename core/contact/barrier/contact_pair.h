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
    double stiffness;                 ///< N/m, of the material between the elements (see ContactSurface)
    double activation_distance;       ///< m, distance of the middle surfaces below which the pair acts
    EdgeMollifier mollifier;          ///< used by edge-edge pairs only
    double closest = 0.75;            ///< minimum distance over activation distance
    bool spring = false;              ///< whether a spring replaces the barrier: see Barrier
    SecondSpring second_spring = {};  ///< used only if `spring` is true

    double minimum() const { return closest * activation_distance; }  ///< m, minimum distance
    Barrier barrier() const { return {activation_distance - minimum(), spring, second_spring}; }
    double largest_stiffness() const {
        return stiffness * (1 + second_spring.stiffness());
    }  ///< N/m, valid only if `spring` is true
};

/// Sorts pairs by their kind, then by their vertices.
void sort(std::vector<ContactPair>& pairs);

/// Distance of the two elements, m.
double distance(const ContactPair& pair, const PairPositions& x);
/// Whether the distance of the two elements is less than `limit`, m.
bool within(double limit, const ContactPair& pair, const PairPositions& x);

/// Energy, J: the stiffness times the mollifier times the barrier at the gap. The gap is the distance of the
/// two elements less the minimum distance.
double value(const ContactPair& pair, const PairPositions& x);
/// dE/dx, N, [3, 4]. The forces on the four vertices have no resultant and no net torque.
PairPositions gradient(const ContactPair& pair, const PairPositions& x);
/// d2E/dx2, N/m. With `convex`, returns a positive semidefinite approximation: the Gauss-Newton part, or,
/// where the mollifier of an edge-edge pair is active, the positive semidefinite part of the exact matrix.
PairHessian hessian(const ContactPair& pair, const PairPositions& x, bool convex);

}  // namespace sherd
