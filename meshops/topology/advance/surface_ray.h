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
    /// Returns the ray from a vertex along the tangential part of `direction`. It begins in the face that
    /// contains it in a view along the vertex's normal, and is `length` (m) long, but ends at the boundary
    /// and at an edge for which `stops` is true. Returns nullopt if it points off the sheet, or has no
    /// tangential part.
    static std::optional<SurfaceRay> from(const Mesh& mesh, Vertex tip, const Eigen::Vector3d& direction,
                                          double length, const std::function<bool(Edge)>& stops);

    Face first_face() const { return segments.front().face; }
    /// Unit vector of the ray at its start, in the plane of the first face.
    const Eigen::Vector3d& direction() const { return segments.front().direction; }
    /// Unit vector of the ray at a distance (m) from its start.
    const Eigen::Vector3d& direction_at(double distance) const { return segment_at(distance).direction; }
    double length() const { return whole; }  ///< m, up to its end or to where it is stopped
    /// Halfedge at which the ray is stopped, in the face before it; null if it is not stopped.
    Halfedge end() const { return stop; }
    /// Crossing of the ray with end(), as a fraction of the way from source to target.
    double end_fraction() const { return stop_fraction; }
    /// Place at a distance of at most length() from the start.
    SurfacePoint at(const Mesh& mesh, double distance) const;

  private:
    struct Segment {
        Face face;
        Eigen::Vector3d start, direction;
        double begin;  ///< distance of its start from the ray's, m
    };
    const Segment& segment_at(double distance) const;

    std::vector<Segment> segments;
    double whole = 0;
    Halfedge stop = Mesh::null_halfedge();
    double stop_fraction = 0;
};

/// Sum of the unit normals of the faces at a vertex, each weighted by its angle there.
Eigen::Vector3d vertex_normal(const Mesh& mesh, Vertex vertex);

}  // namespace sherd
