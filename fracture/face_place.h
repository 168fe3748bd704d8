// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Place of a face for messages and reports; sheet -1: none.
struct FacePlace {
    Index sheet = -1;                  ///< number of the input
    Vector3d rest = Vector3d::Zero();  ///< m, the middle of the face at rest
};

inline FacePlace face_place(const Shell& shell, Index face) {
    return {shell.face_sheet[face], columns(shell.rest, shell.triangles[face].vertices).rowwise().mean()};
}

}  // namespace sherd
