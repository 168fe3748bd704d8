// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/advance_edge.h"

namespace sherd {

/// A vertex at a point of the mesh.
struct PlacedVertex {
    Vertex vertex;
    double smallest_angle;  ///< smallest angle of the changed faces, rad; pi if there are none
    TopologyChange change;
};

/// Makes a vertex at `point` as advance_edge() does: moves a corner of its face there, or inserts a vertex.
/// If a line is within `near` (m) of the point, its nearest point replaces the point. A corner within `near`
/// that cannot be moved is used as it is. The best change is made, whatever its angles.
PlacedVertex place_vertex(Mesh& mesh, const SurfacePoint& point, double near, const AdvanceOptions& options);

}  // namespace sherd
