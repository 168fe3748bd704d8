// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/growing_tip.h"
#include "fracture/surface_stress.h"

namespace sherd {

// A tempered sheet has the compression Material::tempered at its surfaces, S, and within a tension that
// balances it, in a parabola through the thickness t, alike in all directions: S (3 (2 z / t)^2 - 1) / 2. On
// a shell it is no load. But a crack frees its lips of it, and so releases some of its energy, as much as a
// half-infinite strip does whose end is freed of this stress, for either lip: 0.0368 S^2 t^2 (1 - nu^2) / Y
// for a metre of it (plane strain; tests/benchmarks/freed_end.py, for nu from 0.2 to 0.35). It frees a
// point at the distance d of the share exp(-d / reach) / 2 of its energy: of the stress across the crack, and
// not of that along it, which goes on to drive cracks that come across. Of two cracks at an angle both count,
// the farther one by the square of its sine, those two that free the point of most. A piece of a crack frees
// what is beside it, as at its middle: what is left depends on the order of cracks by what differs along it.

/// How much energy residual stress stores, and how far from a crack it is gone.
struct ResidualStress {
    double energy = 0;  ///< J/m^2, where there is no crack: (1 - nu) t S^2 / (5 Y)
    double reach = 0;   ///< m: half of it times the energy is what either lip of a straight crack releases
};

/// Zero in a sheet that is not tempered.
ResidualStress residual_stress(const Material& material);

/// What all sheets store where no edge has failed but these, J.
double residual_energy(const BreakableShell& shell, std::span<const Edge> cracks);

/// A straight piece of a crack, m, in the rest shape.
struct CrackPiece {
    Vector3d from, to;
};

/// The energy of residual stress, J for a metre of it, that a crack releases which goes on from a vertex to a
/// point of the rest shape, beside the cracks that there are and those of `others`: as at the middle of the
/// way, which ends where the sheet does.
double residual_release(const BreakableShell& shell, Vertex from, const Vector3d& to,
                        std::span<const CrackPiece> others = {});

/// Lets the residual stress ahead of a tip, over the edges there, add to what it bears: G adds, since a
/// stress without a mean through the thickness does no work on the opening by one with. It leads straight on.
void add_residual(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load);

}  // namespace sherd
