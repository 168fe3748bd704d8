// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "meshops/advance_edge.h"

namespace sherd {

/// A point of a polyline, m, and how messages call it.
struct LinePoint {
    Eigen::Vector3d place;
    std::string name;
};

/// Makes edges of a mesh along polylines, by advance_edge(). Crossing lines share a vertex.
class LineCut {
  public:
    /// `mesh` must outlive this. keep_vertices: none of its vertices is moved, faces are cut only.
    LineCut(Mesh& mesh, bool keep_vertices);
    LineCut(const LineCut&) = delete;
    LineCut& operator=(const LineCut&) = delete;

    /// Makes edges along the polyline projected to the surface, as it was in the beginning, point by point to
    /// what is nearest. Vertices are made at its ends and where it turns by more than 20 degrees, on a closed
    /// one at two more points; a corner or a line of the mesh within 0.05 mean edges of these is taken
    /// instead. Throws Error, naming the point, if one is farther from the mesh than the longest edge of the
    /// face next to it, if the line leaves the mesh before it, and if fewer than two points differ.
    void cut(std::span<const LinePoint> line);

    /// Edges along all lines, in order; those on the boundary are open and not among them.
    const std::vector<Edge>& edges() const { return path; }
    double length() const;                              ///< of these, m
    double smallest_angle() const { return smallest; }  ///< of all changed faces, rad; pi if there are none
    std::size_t moved_vertices() const { return moved.size(); }
    std::size_t born_vertices() const;

  private:
    struct Curve {
        std::vector<Eigen::Vector3d> points;
        std::vector<std::size_t> stops;  ///< of the points, those of the polyline where the path has a vertex
        std::vector<std::size_t> ends;   ///< number in the polyline of each stop
    };

    Curve project(std::span<const LinePoint> line) const;
    Vertex vertex_at(const Eigen::Vector3d& place);
    void walk(Vertex from, Vertex to, std::span<const Eigen::Vector3d> curve, const std::string& name);
    void follow(const TopologyChange& change, double angle);
    void add(Halfedge made);

    Mesh& mesh;
    Mesh surface;  ///< as it was in the beginning
    double mean_edge;
    AdvanceOptions options;
    std::vector<Edge> path;
    std::set<Edge> on_path;
    std::set<Vertex> kept, moved;
    double smallest;
};

}  // namespace sherd
