// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "meshops/surface_point.h"

namespace sherd {

/// A straight line over the faces of a surface, in each face's own plane, as if they were unfolded there.
class SurfaceRay {
  public:
    /// The ray from a vertex along `direction`, whose part in the tangent plane counts: the face in which it
    /// begins is the one that it lies in when all are seen along the vertex's normal. It goes on for `length`
    /// (m), but not over the boundary or an edge that `stops` it. Nothing if it points off the sheet, or in
    /// no direction of the tangent plane.
    static std::optional<SurfaceRay> from(const Mesh& mesh, Vertex tip, const Eigen::Vector3d& direction,
                                          double length, const std::function<bool(Edge)>& stops);

    Face first_face() const { return segments.front().face; }
    /// Unit vector of the ray at its start, in the plane of the first face.
    const Eigen::Vector3d& direction() const { return segments.front().direction; }
    /// The same at a distance (m) from its start.
    const Eigen::Vector3d& direction_at(double distance) const { return segment_at(distance).direction; }
    double length() const { return whole; }  ///< m, up to its end or to where it is stopped
    /// The halfedge of the face before it where the ray is stopped; null if it is not.
    Halfedge end() const { return stop; }
    /// Where it crosses end(), as a fraction of the way from source to target.
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

/// Sum of the unit normals of the faces at a vertex, each by its angle there.
Eigen::Vector3d vertex_normal(const Mesh& mesh, Vertex vertex);

}  // namespace sherd
