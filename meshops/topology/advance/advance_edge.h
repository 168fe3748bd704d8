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
    /// Degrees: a vertex is moved onto the ray without further changes if no angle of its faces falls below
    /// this.
    double snap_angle = 22;
    /// Degrees: other changes must leave no angle below this or, if that is smaller, below the smallest angle
    /// of the faces that they replace.
    double smallest_angle = 20;
    /// Degrees: other changes are improved, by more flips and moves, until no angle is below this, if that is
    /// possible. At least smallest_angle.
    double wanted_angle = 20;
    /// Distance of the ray's end from the tip, m: the edge ends there, or far enough before it for another
    /// edge to follow.
    double reach = std::numeric_limits<double>::infinity();
    /// Vertex where the path of edges is to end; null: none. An edge from the tip to this vertex is taken
    /// even if it is off the ray, or is made by a flip if the edge between the two can be flipped.
    Vertex goal = Mesh::null_vertex();
    /// Whether to make the best change if no change keeps the angles; without it, an existing edge is taken.
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
    Halfedge halfedge;          ///< halfedge from the tip to the other end of the edge
    Eigen::Vector3d direction;  ///< unit vector of the ray at that end, in the plane of the face there
    double off_course;          ///< angle between edge and ray at the tip, rad; 0 unless `existing`
    double smallest_angle;      ///< smallest angle of the changed faces, rad; pi if there are none
    TopologyChange change;
};

/// Makes an edge along the ray from `tip` in `direction` (see SurfaceRay) by the first of these that is
/// possible and keeps the angles of `options`:
/// - an existing edge that lies on the ray is taken;
/// - a neighbour of the tip beside the ray is moved onto the ray; the neighbour at the smaller angle to the
///   ray is tried first;
/// - such a neighbour is moved onto the ray, with flips and moves of other vertices around it;
/// - a vertex is inserted on the ray, within the face in which the ray begins or by splitting the edge
///   through which the ray leaves it, with flips and moves;
/// - the existing edge at the smallest angle to the ray is taken.
/// The edge is at most 1.6 times as long as the mean edge at the tip, and ends at the latest where the ray
/// meets a line (LineConstraints) or the boundary. Vertices stay on the old surface; the tip and the vertices
/// and lines of options.kept stay where they are. At most one vertex is inserted. Returns nullopt if the ray
/// points off the sheet.
std::optional<AdvancedEdge> advance_edge(Mesh& mesh, Vertex tip, const Eigen::Vector3d& direction,
                                         const AdvanceOptions& options);

}  // namespace sherd
