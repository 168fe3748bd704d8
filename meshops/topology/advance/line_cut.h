// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "meshops/topology/advance/advance_edge.h"

namespace sherd {

/// A point of a polyline: its place, m, and its name in messages.
struct LinePoint {
    Eigen::Vector3d place;
    std::string name;
};

/// Makes edges of a mesh along polylines, by advance_edge(). Crossing lines share a vertex.
class LineCut {
  public:
    /// `mesh` must outlive this. keep_vertices: whether faces are only cut, and no vertex is moved.
    LineCut(Mesh& mesh, bool keep_vertices);
    LineCut(const LineCut&) = delete;
    LineCut& operator=(const LineCut&) = delete;

    /// Makes edges along the polyline, which is projected point by point to the nearest points of the
    /// original surface. Vertices are placed at the ends of the polyline, where it turns by more than 20
    /// degrees and, if it is closed, at two more points. If a line of the mesh (LineConstraints), or a vertex
    /// that may not move, is within 0.05 mean edges of such a place, it is used instead. Throws Error, naming
    /// the point, if a point is farther from the mesh than the longest edge of the nearest face, if the line
    /// leaves the mesh before a point, and if fewer than two points differ.
    void cut(std::span<const LinePoint> line);

    /// Edges along all lines so far, without edges on the boundary, which are open already.
    const std::vector<Edge>& edges() const { return path; }
    double length() const;                              ///< total length of edges(), m
    double smallest_angle() const { return smallest; }  ///< smallest angle of changed faces, rad; pi: none
    std::size_t moved_vertices() const { return moved.size(); }
    std::size_t inserted_vertices() const;

  private:
    struct Curve {
        std::vector<Eigen::Vector3d> points;
        std::vector<std::size_t> stops;  ///< indices in `points` of places where the path has a vertex
        std::vector<std::size_t> ends;   ///< index in the polyline of the point of each stop
    };

    Curve project(std::span<const LinePoint> line) const;
    Vertex vertex_at(const Eigen::Vector3d& place);
    void walk(Vertex from, Vertex to, std::span<const Eigen::Vector3d> curve, const std::string& name);
    void follow(const TopologyChange& change, double angle);
    void add(Halfedge made);

    Mesh& mesh;
    Mesh surface;  ///< the mesh before all changes
    double mean_edge;
    AdvanceOptions options;
    std::vector<Edge> path;
    std::set<Edge> on_path;
    std::set<Vertex> kept, moved;
    double smallest;
};

}  // namespace sherd
