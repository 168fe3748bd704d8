// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "meshops/topology/advance/patch.h"
#include "meshops/topology/surface_point.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

struct AdvanceOptions {
    /// Whether a vertex may be moved onto the ray; if not, faces are always cut.
    bool snap = true;
    /// A vertex is moved without further changes if no angle of its faces falls below this, degrees.
    double snap_angle = 22;
    /// Smallest angle, in degrees, that other changes may leave; or that of the faces that they replace, if
    /// it is smaller.
    double smallest_angle = 20;
    /// Distance of the ray's end from the tip, m: the edge ends there, or far enough before it for another
    /// edge to follow.
    double reach = std::numeric_limits<double>::infinity();
    /// Vertex where the path is to end. An edge from the tip to it is taken even if it is off the ray, or
    /// made by flipping the edge between them.
    Vertex goal = Mesh::null_vertex();
    /// Whether to make the best change where none keeps the angles, instead of taking an existing edge.
    bool always_straight = false;
    LineConstraints kept;
};

/// An edge of a mesh along a requested ray.
struct AdvancedEdge {
    enum class Way : std::uint8_t {
        existing,  ///< an existing edge, unchanged
        snapped,   ///< a vertex was moved onto the ray
        relaxed,   ///< a vertex was moved onto the ray, with flips and moves around it
        cut        ///< faces were cut at an inserted vertex
    };
    Way way;
    Halfedge halfedge;          ///< from the tip to the edge's other end
    Eigen::Vector3d direction;  ///< unit vector of the ray there, in the plane of its last face
    double off_course;          ///< angle between edge and ray at the tip, rad; 0 unless `existing`
    double smallest_angle;      ///< smallest angle of the changed faces, rad; pi if there are none
    TopologyChange change;
};

/// Makes an edge along the ray from `tip` in `direction` (see SurfaceRay), in this order:
/// - an edge that lies on the ray is taken;
/// - the neighbour nearest to the ray by its angle, or else the one on the other side, is moved onto the ray;
/// - a neighbour is moved onto the ray with flips and moves of other vertices around it;
/// - a vertex is inserted on the ray, within the tip's face or by splitting the edge through which the ray
///   leaves it, with flips and moves;
/// - the edge nearest to the ray is taken.
/// The edge is not longer than 1.6 mean edges of the tip, and ends where the ray meets a line or the
/// boundary. Vertices stay on the old surface; the tip and the vertices and lines of `kept` stay. At most one
/// vertex is inserted. Returns nullopt if the ray points off the sheet.
std::optional<AdvancedEdge> advance_edge(Mesh& mesh, Vertex tip, const Eigen::Vector3d& direction,
                                         const AdvanceOptions& options);

}  // namespace sherd
