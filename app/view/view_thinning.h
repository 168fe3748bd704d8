// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Coarser meshes of a recording's frames, for pictures. Space at rest is divided into cubes. In each frame
/// the vertices of a fragment that come from the same cube are merged into one, in their middle, so that
/// fragments separate as recorded. Faces of the unfractured mesh with corners in three cubes remain, in all
/// frames; fragments smaller than a cube may have none. Cracks within a fragment are shown by edges that are
/// not open. An inserted vertex belongs to the cube of the nearest of its parents, so that one part of a face
/// that was split has its corners in the three cubes, and represents the face.
class MeshThinning {
  public:
    /// face_sheet: [F] or longer, sheets, whose vertices are kept apart; cube: m, length of an edge.
    MeshThinning(const RecordingHeader& header, std::span<const Index> face_sheet, double cube);

    /// Returns step, time, position, faces, face_fragment, fields, edges and rest, without positions and
    /// areas at rest, where the vertices are cubes; an edge has the mean |strain| of those merged, and is
    /// fractured if one of them is.
    Snapshot thinned(const Snapshot& frame) const;
    double cube_length() const { return length; }  ///< m

  private:
    std::vector<Index> cubes_of(const RestMesh& rest) const;

    double length;
    std::vector<Index> cubes;       ///< [V0] index of the cube of each vertex at rest, -1: unused
    Index count = 0;                ///< number of cubes
    std::vector<std::size_t> kept;  ///< faces of the unfractured mesh that remain
};

}  // namespace sherd
