// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/retriangulation.h"

namespace sherd {

/// Lets new and changed elements of `mesh` inherit properties. Texture coordinates are those of the old faces
/// at the places of the corners; a corner on a seam has those of its face's side. Groups, material and colour
/// are those of the old face with the largest share, material axes the mean weighted by area, and colours of
/// vertices are interpolated. Inserted vertices have no number in a file: they get the largest std::uint32_t.
/// old: the faces in `change` as they were.
void inherit_properties(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change);

}  // namespace sherd
