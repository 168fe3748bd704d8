// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// A chain of edges that remeshing keeps, from corner to corner.
struct FeatureLine {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> along;             ///< m, distance of each point along the line, ascending
    std::vector<Vertex> vertices;          ///< vertex at each point
    bool is_shared = false;                ///< whether lines of other sheets have the same points
    Eigen::Vector3d at(double way) const;  ///< point at the distance `way` (m) along the line
    double length() const { return along.back(); }
};

/// Part of a line that an edge covers.
struct LineStretch {
    static constexpr std::int32_t none = -1;
    std::int32_t line = none;
    Vertex begin, end;                ///< ends of the edge, in any order
    double at_begin = 0, at_end = 0;  ///< m, distances of `begin` and `end` along the line
};

/// Lines of a mesh: boundary edges, edges where groups, materials or texture coordinates change, sharp edges,
/// edges along which the mesh lies on itself without being joined, and edges of faces whose shape is kept.
struct FeatureLines {
    std::vector<FeatureLine> lines;
    std::vector<LineStretch> of_edge;             ///< [E] part of a line that each edge covers
    std::vector<char> is_corner;                  ///< [V] whether lines end, branch or turn there
    std::vector<std::vector<Vertex>> coincident;  ///< sets of coincident vertices of shared lines
};

/// Returns the faces `near` and the faces that are connected to them through faces whose middles are less
/// than `reach` (m) from `place`; at most about 64.
std::vector<Face> faces_near(const Mesh& mesh, std::vector<Face> near, const Eigen::Vector3d& place,
                             double reach);

/// Finds the lines of a mesh that has no gaps in its numbers. Edges are sharp if their dihedral angle exceeds
/// `degrees`. A line has a corner where it turns by more than `degrees`, both from edge to edge and measured
/// over a third of `edge_length` (m), so that zigzags of a seam are no corners. Sharp edges of which less
/// than `edge_length` is connected, as in noise, are not kept as lines. kept: [F] whether the shape of each
/// face is kept.
FeatureLines feature_lines(const Mesh& mesh, double degrees, double edge_length,
                           const std::vector<char>& kept);

}  // namespace sherd
