// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/advance_edge.h"

namespace sherd {

/// A vertex at a point of the mesh.
struct PlacedVertex {
    Vertex vertex;
    double smallest_angle;  ///< of the changed faces, rad; pi if there are none
    TopologyChange change;
};

/// Makes a vertex at `point` in the way advance_edge() does: a corner of its face is moved there, or one is
/// born. A corner that cannot be moved there is taken as it is if it is within `near` (m) of the point, and
/// so is the nearest point of a line. The best change is made, whatever its angles.
PlacedVertex place_vertex(Mesh& mesh, const SurfacePoint& point, double near, const AdvanceOptions& options);

}  // namespace sherd
