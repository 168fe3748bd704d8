// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "meshops/topology/topology_change.h"

namespace sherd {

/// Opens the mesh at `vertices` along the edges for which `is_cut` is true: two corners at one of these
/// vertices still share it if and only if they are connected through faces around it without crossing a cut
/// edge or the boundary. A cut edge opens if and only if its two sides get different vertices at one end. The
/// faces around a vertex that remain connected with its lowest face keep the vertex, so that the result does
/// not depend on the order of `vertices`. A vertex at the far end of an edge that opens must have no other
/// cut edge, or be one of `vertices`; it is always enough to pass both ends of every newly cut edge. The time
/// is proportional to the number of faces around these vertices.
TopologyChange split_vertices(Mesh& mesh, std::span<const Vertex> vertices,
                              const std::function<bool(Edge)>& is_cut);

}  // namespace sherd
