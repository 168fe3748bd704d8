// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/topology/retriangulation.h"

namespace sherd {

/// Gives a copy of a vertex the attributes of the vertex.
void copy_attributes(Mesh& mesh, Vertex vertex, Vertex copy);

/// Lets new and changed elements of `mesh` inherit the attributes of their parents, each by its rule
/// (Inherits). Texture coordinates of a corner on a seam are those of its face's side.
/// old: the faces in `change` as they were.
void inherit_attributes(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change);

}  // namespace sherd
