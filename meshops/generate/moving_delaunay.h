// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "meshops/generate/surface.h"

namespace sherd {

/// Delaunay triangulation, in the chart of a surface, of points that move. It is updated by moving its
/// vertices and then flipping edges until all are Delaunay again (Lawson 1977). The result equals a new
/// triangulation, but takes a fraction of the time if most triangles stay as they are.
class MovingDelaunay {
  public:
    using Corners = std::array<std::size_t, 3>;

    /// `surface` and `points` must outlive this object. Throws Error if there are too few points for the
    /// shape.
    MovingDelaunay(const Surface& surface, const SurfacePoints& points);
    ~MovingDelaunay();

    /// Updates the triangulation after points, except the fixed ones, have moved. Throws Error as the
    /// constructor does.
    void follow();
    /// Returns the triangles of the surface, ascending, each with its lowest vertex first. In a closed
    /// surface, the vertex at infinity has the number after the last point.
    std::vector<Corners> triangles();

  private:
    struct Triangulation;

    void make();
    bool move();
    bool hull_rests() const;
    void require_edges() const;
    void mark();

    const Surface& surface;
    const SurfacePoints& points;
    std::unique_ptr<Triangulation> of;
};

/// Throws the Error for a shape that has too few points.
[[noreturn]] void throw_generation_error();

}  // namespace sherd
