// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/bending/mirror_hinge.h"
#include "core/energy.h"

namespace sherd {

/// The energy of stretching.
enum class MembraneModel {
    constant_strain,  ///< flat triangles, which lock on thin curved sheets: see MembraneEnergy
    arc               ///< triangles with arcs for sides, which do not: see ArcMembrane
};

/// Membrane energy of a shell from its rest shape. The shell must outlive it, and its changes must be passed
/// to topology_changed(). mirrors: continue the sheet where arcs are measured.
std::unique_ptr<Energy> membrane_energy(const Shell& shell, MembraneModel model,
                                        const std::vector<MirrorHinge>& mirrors = {});

/// Measure of how near each face is to locking as a constant-strain triangle, [F]: the largest l^2 |k| / t of
/// its sides, with their length l, the curvature k of the rest shape along them (SideCurvature) and the
/// thickness t. Above locking_limit, bending there is far too stiff.
VectorXd locking(const Shell& shell);
constexpr double locking_limit = 3;

}  // namespace sherd
