// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/element_energy.h"
#include "core/shell/triangle_edge.h"

namespace sherd {

/// A moment on the side of a triangle, about the direction that the side has at rest.
struct EdgeMoment {
    TriangleEdge side;
    Vector3d axis;  ///< unit length, from the side's first end to its second, at rest
    double moment;  ///< N m
};

/// Distributes a moment, in N m per m of rest length, over the sides. A positive moment turns the triangles
/// by the right-hand rule about their sides, which run counterclockwise around them.
std::vector<EdgeMoment> edge_moments(const Shell& shell, std::span<const TriangleEdge> sides, double moment);

/// Triangles that moments turn about one of their sides. The energy is minus the moment times the angle by
/// which a triangle has turned about the axis since the beginning of the step. This is the angle, seen along
/// the axis, of the direction from the foot of the triangle's height, a point of the side, to its apex. The
/// forces are a couple: a force on the apex, across this direction, and the opposite force on the side's
/// ends. In the plane across the axis, the moment of this couple is exactly the given moment at any angle.
struct TurnedTriangles {
    struct Turned {
        std::array<Index, 3> vertices;  ///< the side's ends, then the apex
        double foot;  ///< place of the height's foot on the side at rest: 0 first end, 1 second end
        Eigen::Matrix<double, 2, 3>
            across;      ///< rows: unit vectors that form a right-handed frame with the axis
        Vector2d start;  ///< m, foot to apex at the beginning of the step, in the frame `across`
        double moment;   ///< N m, in the current step
    };
    std::vector<Turned> triangles;

    std::size_t size() const { return triangles.size(); }
    const std::array<Index, 3>& vertices(std::size_t i) const { return triangles[i].vertices; }
    double value(std::size_t i, const TrianglePositions& x) const;
    TrianglePositions gradient(std::size_t i, const TrianglePositions& x) const;
    /// The Hessian is indefinite, as the angle is harmonic; its convex approximation is zero.
    Eigen::Matrix<double, 9, 9> hessian(std::size_t i, const TrianglePositions& x, Curvature curvature) const;
};

/// The triangle that a moment turns, with `share` of the moment, in a step that begins at the shell's
/// positions.
TurnedTriangles::Turned turned_triangle(const Shell& shell, const EdgeMoment& moment, double share);

}  // namespace sherd
