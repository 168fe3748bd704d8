// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// A surface to be meshed. A pair of parameters gives a position in space and a place in a flat chart. What
/// is counterclockwise in the chart is so on the surface, seen from the side that the normals point to. The
/// chart is conformal (small circles stay circles), so that Delaunay triangles of the chart are approximately
/// Delaunay triangles of the surface.
class Surface {
  public:
    virtual ~Surface() = default;
    virtual Eigen::Vector3d position(const Eigen::Vector2d& parameter) const = 0;
    virtual Eigen::Vector2d chart(const Eigen::Vector2d& parameter) const = 0;
    /// Returns the parameters of the point on the surface nearest to `point` (m), which is searched around
    /// the parameters `near`.
    virtual Eigen::Vector2d project(const Eigen::Vector3d& point, const Eigen::Vector2d& near) const = 0;
};

/// Vertices on a surface, given by their parameters, before they are triangulated.
struct SurfacePoints {
    std::vector<Eigen::Vector2d> parameter;
    std::size_t hole = 0;   ///< number of the first vertices, which lie around a hole
    std::size_t fixed = 0;  ///< number of the first vertices, which do not move
    std::vector<std::array<std::size_t, 2>> creases;  ///< pairs of fixed vertices that an edge must join
    /// Pairs of fixed vertices that an edge of the boundary must join. A point is inside if a line from it to
    /// infinity crosses an odd number of borders or, without any borders, if it is within the convex hull.
    std::vector<std::array<std::size_t, 2>> borders;
    bool is_closed = false;  ///< whether one more vertex, at the chart's infinity, closes the surface
    Eigen::Vector3d closing_point = Eigen::Vector3d::Zero();  ///< position of that vertex, m
};

/// Distributes the points that are not fixed evenly: moves each to the centroid of its Voronoi cell,
/// `iterations` times, and up to as many times more while there are thin triangles. Returns the Delaunay mesh
/// of all points, with the closing vertex last. Throws Error if there are too few points for the shape.
Mesh relax(const Surface& surface, SurfacePoints points, int iterations);

}  // namespace sherd
