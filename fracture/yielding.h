// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/face_place.h"
#include "fracture/surface_stress.h"

namespace sherd {

/// Where stress is largest beside the yield stress of its sheet.
struct YieldPeak {
    double ratio = 0;  ///< von Mises stress at a surface over Material::yield; 0: no material yields
    FacePlace place;
};

/// The von Mises stress of plane stress (Pa) with the components 00, 11 and 01.
double von_mises(const Vector3d& stress);

/// Over all faces of sheets whose material yields. Residual stress of tempered sheets is left out.
YieldPeak yield_peak(const BreakableShell& shell, const FaceStrains& strains);

}  // namespace sherd
