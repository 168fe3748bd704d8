// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Makes coarser meshes of a recording's frames, for pictures. Space at rest is divided into cubes. In each
/// frame the vertices of a fragment that come from the same cube are merged into a single vertex, at their
/// mean position, so that fragments separate as recorded. Faces of the unfractured mesh with corners in three
/// different cubes remain in all frames; fragments smaller than a cube may lose all faces. A crack within a
/// fragment does not open, and is shown by its failed edges only. A vertex that a crack has inserted belongs
/// to the cube of the nearest of its parents. One part of a face that a crack has split has its corners in
/// the same three cubes as the face, and represents the face.
class MeshThinning {
  public:
    /// face_sheet: [F] or longer, sheet of each face; vertices of different sheets are not merged. cube: m,
    /// length of the cubes' edges.
    MeshThinning(const RecordingHeader& header, std::span<const Index> face_sheet, double cube);

    /// Returns a frame with step, time, position, faces, face_fragment, fields, edges and rest, where `rest`
    /// has no positions and areas, and its vertices are the cubes. An edge has the mean |strain| of the edges
    /// that are merged into it, and is fractured if one of them is.
    Snapshot thinned(const Snapshot& frame) const;
    double cube_length() const { return length; }  ///< m, length of the cubes' edges

  private:
    std::vector<Index> cubes_of(const RestMesh& rest) const;

    double length;
    std::vector<Index> cubes;       ///< [V0] cube of each vertex of the unfractured mesh; -1: no remaining
                                    ///< face has a corner in its cube
    Index count = 0;                ///< number of cubes with corners of remaining faces
    std::vector<std::size_t> kept;  ///< faces of the unfractured mesh that remain
};

}  // namespace sherd
