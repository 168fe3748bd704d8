// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/barrier/contact_pair.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_friction.h"

namespace sherd {

/// The energy of a contact of a free body, as a function of the places of the `count` points on which its
/// forces act.
struct BodyForce {
    struct Point {
        Index vertex;          ///< vertex of the shell; -1: the point is on a collider
        std::size_t collider;  ///< number of the collider, bodies before obstacles
    };
    int count;
    std::array<Point, 4> points;
    PairPositions at;        ///< m, in space
    PairPositions moved;     ///< m, displacements in the step; zero for springs
    double value;            ///< J
    PairPositions gradient;  ///< N
    bool elastic;            ///< whether the energy is stored, instead of dissipated by friction

    /// A force on a point at x, and the opposite one on a collider's point at `anchor`; m, in space.
    static BodyForce between(Point point, const Vector3d& x, std::size_t collider, const Vector3d& anchor,
                             const PointForce& force, bool elastic) {
        BodyForce all{2, {point, Point{-1, collider}}, {}, {}, force.value, {}, elastic};
        all.at << x, anchor, Positions::Zero(3, 2);
        all.moved << x - anchor, Positions::Zero(3, 3);
        all.gradient << force.gradient, -force.gradient, Positions::Zero(3, 2);
        return all;
    }
    static BodyForce of(const ContactPair& pair, const std::array<Point, 4>& points, const PairPositions& at,
                        const PairPositions& moved) {
        return {4, points, at, moved, sherd::value(pair, at), sherd::gradient(pair, at), true};
    }
    static BodyForce of(const SlidingPair& pair, const std::array<Point, 4>& points, const PairPositions& at,
                        const PairPositions& moved) {
        return {4, points, at, moved, pair.value(moved), pair.gradient(moved), false};
    }
    /// Virtual work, J, of the displacements in the step against the force.
    double work() const { return gradient.cwiseProduct(moved).sum(); }
};

/// The second derivative, N/m, of the energy of BodyForce::between().
inline PairHessian between_points(const Matrix3d& hessian) {
    PairHessian all = PairHessian::Zero();
    all.topLeftCorner<3, 3>() = all.block<3, 3>(3, 3) = hessian;
    all.block<3, 3>(0, 3) = all.block<3, 3>(3, 0) = -hessian;
    return all;
}

}  // namespace sherd
