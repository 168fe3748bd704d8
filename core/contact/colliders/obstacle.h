// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <set>

#include "core/contact/geometry/shape.h"
#include "core/contact/geometry/solid_surface.h"
#include "core/motion.h"

namespace sherd {

/// What sheets cannot pass through and do not push away.
struct Obstacle {
    std::shared_ptr<const Shape> shape;
    Motion motion;
    double young = 3e10;  ///< Pa, of what it is made of
    double friction = 0;  ///< Coulomb coefficient
    /// Of the shape, in its frame. Without it only vertices of sheets meet the obstacle: enough for a plane.
    std::shared_ptr<const SolidSurface> surface = nullptr;

    bool moves() const { return !motion.keys.empty(); }
};

/// How far a point with a skin is inside a shape.
struct Overlap {
    double depth = 0;  ///< m, positive when they touch
    Vector3d normal = Vector3d::Zero();
    Matrix3d curvature = Matrix3d::Zero();  ///< 1/m, Hessian of the shape's distance
};

/// What touches obstacles and bodies.
struct Touch {
    std::set<Index> vertices;                 ///< of sheets, by themselves or with a triangle or an edge
    double deepest = 0;                       ///< m, depth of the deepest one's skin
    std::set<std::size_t> obstacles, bodies;  ///< that a sheet or a body touches

    void include(Index vertex, double depth) {
        if (depth <= 0) return;
        vertices.insert(vertex);
        deepest = std::max(deepest, depth);
    }
    void include(const Touch& other) {
        vertices.insert(other.vertices.begin(), other.vertices.end());
        deepest = std::max(deepest, other.deepest);
        obstacles.insert(other.obstacles.begin(), other.obstacles.end());
        bodies.insert(other.bodies.begin(), other.bodies.end());
    }
};

/// `x` in space, with a skin of `half` (m) around it, against a shape that stands as `pose` says.
Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half);

/// Stiffness, N/m, of a column of sheet (footprint, m^2; thickness, m; young, Pa) against a material:
/// footprint / thickness / (1 / Y_sheet + 1 / Y_obstacle).
inline double column_stiffness(double footprint, double thickness, double young, double obstacle_young) {
    return footprint / thickness / (1 / young + 1 / obstacle_young);
}

}  // namespace sherd
