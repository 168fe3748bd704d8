// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "meshops/generate/surface.h"

namespace sherd {

/// Delaunay triangulation, in the chart, of points that move. The result equals that of a new triangulation,
/// in a fraction of the time where most triangles stay as they are: points are moved, and edges flipped until
/// all are Delaunay again (Lawson 1977).
class MovingDelaunay {
  public:
    using Corners = std::array<std::size_t, 3>;

    /// Surface and points must outlive this object. Throws Error if there are too few points for the shape.
    MovingDelaunay(const Surface& surface, const SurfacePoints& points);
    ~MovingDelaunay();

    /// Updates the triangulation after points that are not fixed have moved. Throws Error as the constructor
    /// does.
    void follow();
    /// Returns the triangles of the surface, ascending, each with its lowest vertex first. The vertex at
    /// infinity has the number after the last vertex.
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
