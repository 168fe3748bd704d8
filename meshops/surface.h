// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// A surface that a mesh is spread over: two parameters, a place in space for each pair of them, and a flat
/// chart, counterclockwise seen from where the normals point to. The chart is conformal (it keeps circles
/// round as long as they are small), so that Delaunay triangles of the chart are Delaunay triangles of the
/// surface.
class Surface {
  public:
    virtual ~Surface() = default;
    virtual Eigen::Vector3d position(const Eigen::Vector2d& parameter) const = 0;
    virtual Eigen::Vector2d chart(const Eigen::Vector2d& parameter) const = 0;
    /// Parameter of the place on the surface that is nearest to `point`, looked for around `near`.
    virtual Eigen::Vector2d project(const Eigen::Vector3d& point, const Eigen::Vector2d& near) const = 0;
};

/// Vertices on a surface, by parameter, before there are triangles.
struct SurfacePoints {
    std::vector<Eigen::Vector2d> parameter;
    std::size_t hole = 0;                             ///< the first so many lie round a hole of the chart
    std::size_t fixed = 0;                            ///< the first so many stay where they are
    std::vector<std::array<std::size_t, 2>> creases;  ///< pairs of fixed vertices to be joined by an edge
    bool is_closed = false;  ///< whether one more vertex closes the surface, at the infinity of the chart
    Eigen::Vector3d closing_point = Eigen::Vector3d::Zero();  ///< its place
};

/// Spreads the points that are not fixed evenly, by moving each to the centroid of its surroundings
/// `iterations` times over (twice that while there are thin triangles), and returns their Delaunay mesh.
/// Throws Error when the points are too few for the shape. The closing vertex comes last.
Mesh relax(const Surface& surface, SurfacePoints points, int iterations);

}  // namespace sherd
