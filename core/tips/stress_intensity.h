// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/bending/coupled_bending.h"
#include "core/tips/crack_tip.h"
#include "core/tips/near_tip_fields.h"

namespace sherd {

// Stress intensity factors at a crack's tip, for isotropic sheets, by interaction integrals (Stern, Becker
// and Dunham, A contour integral computation of mixed-mode stress intensity factors, 1976; as integrals over
// faces: Shih and Asaro, Elastic-plastic analysis of cracks on bimaterial interfaces, 1988). An interaction
// is the energy release of the sum of the sheet's fields and the fields of a single mode, less the releases
// of the sheet's fields alone and of the mode's fields alone. The crack is taken as straight near the tip,
// along its direction; on a path of edges that turns, TipForce gives the release. Faces are unfolded into the
// tip's tangent plane: each face is turned into it by the smallest rotation, and keeps its distance from the
// tip. Displacements are measured in the frame that turns with the sheet at the tip.

/// The material at a face; nothing if it is not isotropic, within a relative tolerance of 1e-6.
std::optional<PlaneStress> isotropic_at(const Shell& shell, Index face);
/// The material at a face. Throws std::invalid_argument if it is not isotropic.
PlaneStress plane_stress_at(const Shell& shell, Index face);

/// K_I and K_II of the membrane, Pa m^0.5, from the faces between the first ring and the second, or, if there
/// is no first ring, from the faces at the tip. x: [3, V] m.
ModePair membrane_intensity(const Shell& shell, const VertexFaces& around, const CrackTip& tip,
                            const Positions& x);

/// k_1 and k_2 of bending, Pa m^0.5, from the faces in all rings of the tip. The value is meaningful only if
/// the tip has two rings or more.
ModePair plate_intensity(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                         const CrackTip& tip, const Positions& x);

}  // namespace sherd
