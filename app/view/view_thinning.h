// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Coarser meshes of a recording's frames, for pictures. Space at rest is cut into cubes; the vertices of one
/// fragment that come from one cube are merged to one in their middle, in each frame anew, so that fragments
/// part as they did. Faces of the unbroken mesh with corners in three cubes stay, in all frames; fragments
/// smaller than a cube may have none. Cracks within a fragment are seen at edges that are not open. A vertex
/// that was born in between is in the cube of the nearest of its parents, so that one part of a face that was
/// split has its corners in the three cubes, and stands for the face.
class MeshThinning {
  public:
    /// face_sheet: [F] or longer, of faces whose vertices are kept apart; cube: m, length of an edge.
    MeshThinning(const RecordingHeader& header, std::span<const Index> face_sheet, double cube);

    /// Only time, position, faces, face_fragment, edges and rest without places and areas, whose vertices are
    /// cubes; an edge has the mean |strain| of those merged, and is fractured if one of them is.
    Snapshot thinned(const Snapshot& frame) const;
    double cube_length() const { return length; }  ///< m

  private:
    std::vector<Index> cubes_of(const RestMesh& rest) const;

    double length;
    std::vector<Index> cubes;       ///< [V0] number of the cube of each vertex at rest, -1: of no use
    Index count = 0;                ///< of cubes
    std::vector<std::size_t> kept;  ///< faces of the unbroken mesh that stay
};

}  // namespace sherd
