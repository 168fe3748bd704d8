// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/tips/configurational_force.h"
#include "fracture/breakable_shell.h"
#include "fracture/growing_tip.h"

namespace sherd {

/// A solution of the sheets, in which the forces of elasticity balance loads, inertia and contact.
struct Equilibrium {
    Positions x;                    ///< [3, V] m
    Positions elastic;              ///< [3, V] N, derivative of the elastic energy
    Positions on_lips;              ///< [3, V] N, of lips that press on each other
    const CoupledBending* bending;  ///< of the stepper, whose state it has
};

/// What tips bear by the energy that they release (core/tips), with up to two rings. Along a straight path it
/// is the component of the configurational force along it, raised in the membrane by what the largest hoop
/// stress of K_I and K_II exceeds it by, since a crack that turns releases more than one that goes straight
/// on. Where the last edge is off the path, it is the length of the force. The direction is that of the
/// largest hoop stress, of membrane and bending. In a sheet that is torn out of its plane direction and
/// length are the force's.
class TipEnergy {
  public:
    /// The shell must outlive this object.
    TipEnergy(const BreakableShell& shell, MembraneModel membrane) : shell(shell), membrane(membrane) {}

    /// Must be called when the mesh has changed. tips: all of them.
    void mesh_changed(std::span<const GrowingTip> tips);
    /// Nothing where the energy is not known: at the tips of a crack that is still closed, where cracks join,
    /// or with a membrane of arcs.
    std::optional<TipLoad> load(const GrowingTip& tip, const Equilibrium& state);

  private:
    struct Known {
        CrackTip tip;
        TipForce force;
    };
    Known* known_at(const GrowingTip& tip, const Equilibrium& state);
    /// [V] 1 where the rings of a tip must not reach: other tips, and all of the boundary but its own lips.
    std::vector<char> foreign_to(Index vertex) const;
    /// Enters modes and direction, in a sheet that is isotropic. Returns false, without a direction, where it
    /// is torn out of its plane. straight_on: what going straight on releases, J/m.
    bool add_modes(const Known& known, const Equilibrium& state, double straight_on, TipLoad& load) const;

    const BreakableShell& shell;
    MembraneModel membrane;
    std::optional<VertexFaces> around;
    std::vector<char> foreign;                    ///< [V] 1 on the boundary and at tips
    std::map<Index, std::unique_ptr<Known>> all;  ///< of a tip's vertex; null: its energy is not known
};

}  // namespace sherd
