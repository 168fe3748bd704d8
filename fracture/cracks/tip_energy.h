// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/tips/configurational_force.h"
#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// A solution of the sheets, in which elastic forces balance loads, inertia and contact.
struct Equilibrium {
    Positions x;                    ///< [3, V] m, positions
    Positions elastic;              ///< [3, V] N, derivative of the elastic energy
    Positions on_crack_faces;       ///< [3, V] N, contact forces between crack faces
    const CoupledBending* bending;  ///< coupled hinges of the stepper, in their present state
};

/// Load on tips by the energy that they release (core/tips), with up to two rings of vertices around a tip.
/// On a straight path the release is the component of the configurational force along the path. The
/// membrane's part of it is multiplied by the ratio of the squared largest hoop stress of K_I and K_II to
/// K_I^2 + K_II^2, since a crack that kinks releases more than a straight crack. If the last edge is not on
/// the path, the release is the length of the force. The load's direction is the direction of the largest
/// hoop stress of membrane and bending. In a sheet that is torn out of its plane, the load has the direction
/// of the force, and the release is the force's length.
class TipEnergy {
  public:
    /// The shell must outlive this object.
    TipEnergy(const BreakableShell& shell, MembraneModel membrane) : shell(shell), membrane(membrane) {}

    /// Must be called when the mesh has changed. tips: all tips.
    void mesh_changed(std::span<const GrowingTip> tips);
    /// Returns the load on a tip; nothing if the energy cannot be computed: at a tip of a crack that is still
    /// closed, at a vertex where cracks join, or with a membrane of arcs.
    std::optional<TipLoad> load(const GrowingTip& tip, const Equilibrium& state);

  private:
    struct CachedTip {
        CrackTip tip;
        TipForce force;
    };
    CachedTip* cached_at(const GrowingTip& tip, const Equilibrium& state);
    /// Returns [V] 1 for the vertices that the rings of the tip at `vertex` must not reach: other tips, and
    /// vertices on the boundary except on the tip's own crack faces.
    std::vector<char> foreign_to(Index vertex) const;
    /// Sets modes and direction of `load` in an isotropic sheet. Returns false, and does not set the
    /// direction, if the sheet is torn out of its plane. straight_on: J/m, energy released by straight
    /// propagation.
    bool add_modes(const CachedTip& cached, const Equilibrium& state, double straight_on,
                   TipLoad& load) const;

    const BreakableShell& shell;
    MembraneModel membrane;
    std::optional<VertexFaces> around;
    std::vector<char> foreign;  ///< [V] 1 on the boundary and at tips
    std::map<Index, std::unique_ptr<CachedTip>>
        all;  ///< tips by their vertex; null: the energy cannot be computed
};

}  // namespace sherd
