// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "meshops/topology_change.h"

namespace sherd {

/// Opens the mesh at `vertices` along the edges for which `is_cut`: two corners of one of these vertices stay
/// the same vertex if and only if one can walk between them through faces around it without crossing a cut
/// edge or the boundary. A cut edge opens if and only if its two sides come to differ at one end. The part
/// around a vertex that holds the lowest face keeps its number, so the outcome does not depend on the order
/// of `vertices`. A vertex at the far end of an edge that opens must be uncut otherwise, or be one of
/// `vertices`: both ends of every newly cut edge always suffice. Time: proportional to the fans of these
/// vertices.
TopologyChange split_vertices(Mesh& mesh, std::span<const Vertex> vertices,
                              const std::function<bool(Edge)>& is_cut);

}  // namespace sherd
