// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

// A tempered sheet has the compression S = Material::tempered at its surfaces, balanced by a tension inside.
// With the thickness t, the compression at the height z over the middle surface is S (3 (2 z / t)^2 - 1) / 2,
// equal in all directions. This stress is no load on a shell. But it vanishes on the faces of a crack, which
// so releases energy. Each crack face releases as much energy as a half-infinite strip whose end is freed of
// this stress, 0.0368 S^2 t^2 (1 - nu^2) / Y per metre of crack (plane strain; tests/benchmarks/freed_end.py,
// for nu from 0.2 to 0.35). At a distance d, a crack releases the share exp(-d / reach) / 2 of the local
// energy: the energy of the stress across the crack. The stress along the crack remains, and can still drive
// cracks that cross it. Of two cracks at an angle, the farther one counts with the square of the angle's
// sine; of several cracks, the two count that together release the most. For a piece of a crack, the release
// per metre is evaluated at its middle, so that the remaining energy depends on the order of cracks where the
// release varies along a piece.

/// The energy that residual stress stores, and the length over which its release beside a crack decays.
struct ResidualStress {
    double energy = 0;  ///< J/m^2, stored where there is no crack: (1 - nu) t S^2 / (5 Y)
    double reach = 0;   ///< m, decay length: each face of a straight crack releases energy * reach / 2, J/m
};

/// Residual stress of a sheet of this material; zero if it is not tempered.
ResidualStress residual_stress(const Material& material);

/// Energy of residual stress, J, of all sheets when only the edges `cracks` have failed.
double residual_energy(const BreakableShell& shell, std::span<const Edge> cracks);

/// A straight piece of a crack in the rest shape, from one point (m) to another.
struct CrackPiece {
    Vector3d from, to;
};

/// Energy of residual stress, J per metre, that a crack releases when it propagates from the vertex `from` to
/// the point `to` (m) of the rest shape, in the presence of the mesh's cracks and of the pieces `others`. The
/// release is evaluated at the middle of the path; the path ends where the sheet ends.
double residual_release(const BreakableShell& shell, Vertex from, const Vector3d& to,
                        std::span<const CrackPiece> others = {});

/// Adds to the load on a tip the energy of residual stress that the tip would release by an advance straight
/// ahead, by the mean length of the edges there. The release rates of loads and residual stress add: residual
/// stress has the mean zero through the thickness, and so does no work on an opening that is constant through
/// the thickness. It drives the crack straight ahead, so that the load's direction turns towards the tip's.
void add_residual(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load);

}  // namespace sherd
