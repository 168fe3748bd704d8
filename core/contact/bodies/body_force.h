// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/barrier/contact_pair.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_friction.h"

namespace sherd {

/// The energy of one contact of a free body, with the forces that it exerts on `count` points. The columns of
/// `at`, `moved` and `gradient` belong to these points; unused columns are zero.
struct BodyForce {
    struct Point {
        Index vertex;          ///< vertex of the shell; -1 if the point is on a collider
        std::size_t collider;  ///< number of the point's collider, bodies before obstacles
    };
    int count;
    std::array<Point, 4> points;
    PairPositions at;  ///< m, positions of the points in space
    /// Displacements of the points in the step, m. In between(), the displacement of the first point relative
    /// to the second. Zero where no function needs them.
    PairPositions moved;
    double value;            ///< J
    PairPositions gradient;  ///< N
    bool elastic;            ///< true: the energy is stored; false: it is a potential of friction

    /// The contact of a point at x with a collider's point at `anchor` (both in m, in space): `force` acts on
    /// the first point, and the opposite force on the second.
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
    /// Work, J, that the displacements in the step do against the force; for friction, the energy dissipated.
    double work() const { return gradient.cwiseProduct(moved).sum(); }
};

/// Returns the second derivative, N/m, of the energy of BodyForce::between() by its two points; hessian: the
/// second derivative by the first point.
inline PairHessian between_points(const Matrix3d& hessian) {
    PairHessian all = PairHessian::Zero();
    all.topLeftCorner<3, 3>() = all.block<3, 3>(3, 3) = hessian;
    all.block<3, 3>(0, 3) = all.block<3, 3>(3, 0) = -hessian;
    return all;
}

}  // namespace sherd
