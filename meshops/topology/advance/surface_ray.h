// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "meshops/topology/surface_point.h"

namespace sherd {

/// A straight line over the faces of a surface, in each face's own plane, as if the faces were unfolded.
class SurfaceRay {
  public:
    /// Returns the ray from the vertex `tip` along the part of `direction` that is tangential to the sheet.
    /// Seen along the normal of the vertex, the ray begins in the face into which it points. Its length is
    /// `length` (m), unless the boundary or an edge for which `stops` is true ends it before. Returns nullopt
    /// if the ray points off the sheet, or `direction` has no tangential part.
    static std::optional<SurfaceRay> from(const Mesh& mesh, Vertex tip, const Eigen::Vector3d& direction,
                                          double length, const std::function<bool(Edge)>& stops);

    Face first_face() const { return segments.front().face; }
    /// Unit vector of the ray at its start, in the plane of the first face.
    const Eigen::Vector3d& direction() const { return segments.front().direction; }
    /// Unit vector of the ray at a distance (m) from its start.
    const Eigen::Vector3d& direction_at(double distance) const { return segment_at(distance).direction; }
    double length() const { return whole; }  ///< m, up to its end or to where it is stopped
    /// Halfedge of the last face at which the boundary or `stops` ends the ray; null if neither does.
    Halfedge end() const { return stop; }
    /// Place where the ray meets end(), as a fraction of the halfedge from its source.
    double end_fraction() const { return stop_fraction; }
    /// Returns the place on the ray at a distance (m) of at most length() from its start.
    SurfacePoint at(const Mesh& mesh, double distance) const;

  private:
    struct Segment {
        Face face;
        Eigen::Vector3d start, direction;
        double begin;  ///< distance of `start` from the start of the ray, m
    };
    const Segment& segment_at(double distance) const;

    std::vector<Segment> segments;
    double whole = 0;
    Halfedge stop = Mesh::null_halfedge();
    double stop_fraction = 0;
};

/// Returns the sum of the unit normals of the faces at a vertex, each weighted by its angle there.
Eigen::Vector3d vertex_normal(const Mesh& mesh, Vertex vertex);

}  // namespace sherd
