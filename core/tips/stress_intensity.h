// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/bending/coupled_bending.h"
#include "core/tips/crack_tip.h"
#include "core/tips/near_tip_fields.h"

namespace sherd {

// Stress intensity factors at a crack's tip, of isotropic sheets, by interaction integrals (Stern, Becker and
// Dunham, A contour integral computation of mixed-mode stress intensity factors, 1976; as integrals over
// faces: Shih and Asaro, Elastic-plastic analysis of cracks on bimaterial interfaces, 1988): the energy
// release of the sheet's fields together with those of a single mode, less the releases of each alone. The
// crack is taken as straight near the tip, along its direction; on a path of edges that turns, TipForce gives
// the release. Faces are unfolded into the tip's tangent plane: each is turned there by the smallest
// rotation, at its distance from the tip. Displacements are measured in the frame that turns with the sheet
// at the tip.

/// The material at a face; nothing if it is not isotropic, to 1e-6.
std::optional<PlaneStress> isotropic_at(const Shell& shell, Index face);
/// The material at a face. Throws std::invalid_argument if it is not isotropic.
PlaneStress plane_stress_at(const Shell& shell, Index face);

/// K_I and K_II of the membrane, Pa m^0.5, from the faces between the first ring and the second, or, if there
/// is no first ring, from those at the tip. x: [3, V] m.
ModePair membrane_intensity(const Shell& shell, const VertexFaces& around, const CrackTip& tip,
                            const Positions& x);

/// k_1 and k_2 of bending, Pa m^0.5, from the faces in all rings of the tip, of which two are needed for a
/// meaningful value.
ModePair plate_intensity(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                         const CrackTip& tip, const Positions& x);

}  // namespace sherd
