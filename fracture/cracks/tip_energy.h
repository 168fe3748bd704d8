// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/tips/configurational_force.h"
#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// A solution of the sheets, in which elastic forces balance loads, inertia and contact.
struct Equilibrium {
    Positions x;                    ///< [3, V] m
    Positions elastic;              ///< [3, V] N, derivative of the elastic energy
    Positions on_crack_faces;       ///< [3, V] N, contact between crack faces
    const CoupledBending* bending;  ///< the stepper's, in its state
};

/// Load on tips by the energy that they release (core/tips), with up to two rings. On a straight path the
/// release is the component of the configurational force along it; that of the membrane is raised by the
/// ratio of the squared largest hoop stress of K_I and K_II to K_I^2 + K_II^2, since a crack that kinks
/// releases more than a straight one. Where the last edge is off the path, the release is the length of the
/// force. The direction is that of the largest hoop stress, of membrane and bending. In a sheet that is torn
/// out of its plane, direction and release are those of the force.
class TipEnergy {
  public:
    /// The shell must outlive this object.
    TipEnergy(const BreakableShell& shell, MembraneModel membrane) : shell(shell), membrane(membrane) {}

    /// Must be called when the mesh has changed. tips: all tips.
    void mesh_changed(std::span<const GrowingTip> tips);
    /// Returns the load on a tip; nothing where the energy cannot be computed: at the tips of a crack that is
    /// still closed, where cracks join, or with a membrane of arcs.
    std::optional<TipLoad> load(const GrowingTip& tip, const Equilibrium& state);

  private:
    struct CachedTip {
        CrackTip tip;
        TipForce force;
    };
    CachedTip* cached_at(const GrowingTip& tip, const Equilibrium& state);
    /// [V] 1 where the rings of a tip must not reach: other tips, and the boundary except its own crack
    /// faces.
    std::vector<char> foreign_to(Index vertex) const;
    /// Sets modes and direction of the load in an isotropic sheet. Returns false, without a direction, where
    /// the sheet is torn out of its plane. straight_on: J/m, energy released by straight propagation.
    bool add_modes(const CachedTip& cached, const Equilibrium& state, double straight_on,
                   TipLoad& load) const;

    const BreakableShell& shell;
    MembraneModel membrane;
    std::optional<VertexFaces> around;
    std::vector<char> foreign;  ///< [V] 1 on the boundary and at tips
    std::map<Index, std::unique_ptr<CachedTip>>
        all;  ///< by the tip's vertex; null: energy cannot be computed
};

}  // namespace sherd
