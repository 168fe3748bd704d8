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
    std::vector<double> along;             ///< m from its begin, of each point, rising
    std::vector<Vertex> vertices;          ///< at these points
    bool is_shared = false;                ///< whether lines of other sheets have the same points
    Eigen::Vector3d at(double way) const;  ///< the point that is so far along, m
    double length() const { return along.back(); }
};

/// The part of a line that an edge is. Others are part of none.
struct LineStretch {
    static constexpr std::int32_t none = -1;
    std::int32_t line = none;
    Vertex begin, end;                ///< of the edge, in any order
    double at_begin = 0, at_end = 0;  ///< m along the line
};

/// The lines of a mesh: borders, edges where groups or texture coordinates change, sharp ones, those along
/// which it lies on itself without being joined, and those of faces whose shape is kept.
struct FeatureLines {
    std::vector<FeatureLine> lines;
    std::vector<LineStretch> of_edge;           ///< [E]
    std::vector<char> is_corner;                ///< [V] where lines end, branch or turn
    std::vector<std::vector<Vertex>> together;  ///< vertices of shared lines that are at one place
};

/// The faces that are connected to some by faces whose middles are less than `reach` (m) from a place, with
/// these first; some 64 at most.
std::vector<Face> faces_near(const Mesh& mesh, std::vector<Face> near, const Eigen::Vector3d& place,
                             double reach);

/// The lines of a mesh without gaps in its numbers. Edges are sharp whose faces bend by more than `degrees`;
/// a line turns where it does so by more than that, seen from a third of `edge_length` (m), too, so that a
/// seam may zigzag. Sharp edges that are connected over less than `edge_length`, as in noise, are none. kept:
/// [F] whether the shape of a face is kept.
FeatureLines feature_lines(const Mesh& mesh, double degrees, double edge_length,
                           const std::vector<char>& kept);

}  // namespace sherd
