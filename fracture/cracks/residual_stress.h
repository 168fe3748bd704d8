// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

// A tempered sheet has the compression Material::tempered at its surfaces, S, balanced by a tension inside,
// in a parabola through the thickness t, equal in all directions: S (3 (2 z / t)^2 - 1) / 2. This stress is
// no load on a shell. But it vanishes on the faces of a crack, which so releases energy: for either face as
// much as a half-infinite strip whose end is freed of this stress, 0.0368 S^2 t^2 (1 - nu^2) / Y per metre of
// crack (plane strain; tests/benchmarks/freed_end.py, for nu from 0.2 to 0.35). At a distance d a crack
// releases the share exp(-d / reach) / 2 of the local energy: that of the stress across the crack, and not of
// the stress along it, which can still drive cracks that cross. Of two cracks at an angle both count, the
// farther one with the square of the angle's sine; of several cracks, the two that together release the most.
// A piece of a crack releases the energy beside it at the rate of its middle, so that the remaining energy
// depends on the order of cracks where this rate varies along a piece.

/// The energy that residual stress stores, and the decay length of its release beside a crack.
struct ResidualStress {
    double energy = 0;  ///< J/m^2, where there is no crack: (1 - nu) t S^2 / (5 Y)
    double reach = 0;   ///< m: either face of a straight crack releases half of it times `energy`, J/m
};

/// Residual stress of a sheet of this material; zero if it is not tempered.
ResidualStress residual_stress(const Material& material);

/// Energy of residual stress, J, of all sheets when no edges but `cracks` have failed.
double residual_energy(const BreakableShell& shell, std::span<const Edge> cracks);

/// A straight piece of a crack, m, in the rest shape.
struct CrackPiece {
    Vector3d from, to;
};

/// Energy of residual stress, J/m, that a crack releases by propagating from a vertex to a point of the rest
/// shape, in the presence of existing cracks and `others`. It is evaluated at the middle of the path, which
/// ends where the sheet does.
double residual_release(const BreakableShell& shell, Vertex from, const Vector3d& to,
                        std::span<const CrackPiece> others = {});

/// Adds the residual stress ahead of a tip, over the length of the edges there, to its load. The release
/// rates add, since a stress whose mean through the thickness is zero does no work on the opening by one with
/// a mean. Residual stress drives the crack straight ahead.
void add_residual(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load);

}  // namespace sherd
