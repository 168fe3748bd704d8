// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/retriangulation.h"

namespace sherd {

/// Gives the reshaped faces of `mesh` what files say of faces. Texture coordinates are those of the old faces
/// at the places of the corners; a corner on a seam has those of its face's side. Groups, material
/// and colour are those of the old face with the largest part, material axes the mean by parts, and colours
/// of vertices those of the place. Born vertices have no number in a file: they get the largest one. old: the
/// faces in `change` as they were.
void inherit_properties(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change);

}  // namespace sherd
