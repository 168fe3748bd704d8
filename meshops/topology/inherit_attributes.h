// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/topology/retriangulation.h"

namespace sherd {

/// Gives `copy`, a copy of a vertex, the attributes of the vertex.
void copy_attributes(Mesh& mesh, Vertex vertex, Vertex copy);

/// Gives the elements of `mesh` that `change` has inserted or altered the attributes that they inherit from
/// their parents, each by the rule of the attribute (Inherits). At a seam, a face inherits the texture
/// coordinates of the side of the seam on which it lies. old: the replaced faces, by number, as they were
/// before the change.
void inherit_attributes(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change);

}  // namespace sherd
