// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "meshops/topology/topology_change.h"

namespace sherd {

/// Opens the mesh at `vertices` along cut edges, for which `is_cut` is true, and returns the change. Two
/// corners of faces at one of `vertices` still share this vertex afterwards if and only if they are connected
/// through faces around it without crossing a cut edge or the boundary. A cut edge opens if and only if its
/// two faces get different vertices at one end of it. Faces around a vertex that remain connected with the
/// face of the lowest number keep the vertex, so that the result does not depend on the order of `vertices`.
/// If an edge opens at one of `vertices`, its other end must have no other cut edge, or be one of `vertices`,
/// too; it is always enough to pass both ends of every newly cut edge. The time is proportional to the number
/// of faces around `vertices`.
TopologyChange split_vertices(Mesh& mesh, std::span<const Vertex> vertices,
                              const std::function<bool(Edge)>& is_cut);

}  // namespace sherd
