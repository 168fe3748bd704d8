// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

/// Place of a face for messages and reports; if `sheet` is -1, there is no such face.
struct FacePlace {
    Index sheet = -1;                  ///< number of the sheet among the inputs
    Vector3d rest = Vector3d::Zero();  ///< m, the middle of the face at rest
};

inline FacePlace face_place(const Shell& shell, Index face) {
    return {shell.face_sheet[face], columns(shell.rest, shell.triangles[face].vertices).rowwise().mean()};
}

/// The largest ratio of a face's stress to the yield stress of its sheet, and the face's place.
struct YieldPeak {
    double ratio = 0;  ///< von Mises stress at a surface over Material::yield; 0: no material yields
    FacePlace place;
};

/// Returns the von Mises stress, Pa, of the plane stress (00, 11, 01), Pa.
double von_mises(const Vector3d& stress);

/// Returns the peak over all faces of sheets whose material yields, without the residual stress of tempered
/// sheets.
YieldPeak yield_peak(const BreakableShell& shell, const FaceStrains& strains);

}  // namespace sherd
