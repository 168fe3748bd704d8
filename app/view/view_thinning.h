// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Coarser meshes of a recording's frames, for pictures. Space at rest is cut into cubes; the vertices of one
/// fragment that come from one cube are merged to one in their middle, in each frame anew, so that fragments
/// part as they did. Faces with corners in three cubes stay, the same ones in all frames; fragments smaller
/// than a cube may have none. Cracks within a fragment are seen at edges that are not open.
class MeshThinning {
  public:
    /// face_sheet: [F], whose vertices are kept apart; cube: m, length of an edge.
    MeshThinning(const RecordingHeader& header, std::span<const Index> face_sheet, double cube);

    /// Only rest_faces, whose vertices are cubes, and rest_thickness.
    RecordingHeader thinned(const RecordingHeader& header) const;
    /// Only time, position, faces, face_fragment and edges; an edge has the mean |strain| of those merged,
    /// and is fractured if one of them is.
    Snapshot thinned(const Snapshot& frame) const;
    double cube_length() const { return length; }  ///< m

  private:
    double length;
    std::vector<Index> cubes;       ///< [V0] number of the cube of each vertex at rest, -1: of no use
    Index count = 0;                ///< of cubes
    std::vector<std::size_t> kept;  ///< faces that stay
};

}  // namespace sherd
