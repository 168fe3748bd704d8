// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/bending/mirror_hinge.h"
#include "core/energy.h"

namespace sherd {

/// The energy of stretching.
enum class MembraneModel {
    constant_strain,  ///< flat triangles, which lock on thin curved sheets: see MembraneEnergy
    arc               ///< triangles with arcs for sides, which do not lock: see ArcMembrane
};

/// Membrane energy of a shell from its rest shape. The shell must outlive it, and its changes must be passed
/// to topology_changed(). mirrors: with arcs, they continue the sheet beyond its sides.
std::unique_ptr<Energy> membrane_energy(const Shell& shell, MembraneModel model,
                                        const std::vector<MirrorHinge>& mirrors = {});

/// Measure of how near each face is to locking as a constant-strain triangle, [F]: the largest l^2 |k| / t of
/// its sides, with their length l, the curvature k of the rest shape along them (SideCurvature) and the
/// thickness t. A face above locking_limit is far too stiff in bending.
VectorXd locking(const Shell& shell);
constexpr double locking_limit = 3;

}  // namespace sherd
