// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/bending/bending.h"
#include "core/bending/coupled_bending.h"
#include "core/bending/mirror_hinge.h"
#include "core/energy_balance.h"
#include "core/forces/damping.h"
#include "core/forces/given_forces.h"
#include "core/forces/loads.h"
#include "core/forces/wind.h"
#include "core/membrane/membrane.h"
#include "core/reaction.h"
#include "core/state_visitor.h"

namespace sherd {

class ArcMembrane;

struct ShellEnergyOptions {
    BendingOptions bending = {};  ///< energy and Jacobian of the hinges
    MembraneModel membrane = MembraneModel::constant_strain;
    std::vector<MirrorHinge> mirrors = {};    ///< clamps and symmetry planes
    std::vector<Index> mirror_supports = {};  ///< number of each mirror's support; empty: no reactions
    std::vector<Load> loads = {};
    std::vector<Wind> winds = {};
    Damping damping = {};
    /// Yield stress of each sheet, Pa, beyond which coupled hinges bend plastically; 0: the sheet does not
    /// yield. Empty: no sheet yields.
    std::vector<double> yields = {};
    bool given_forces = false;  ///< whether ShellEnergies::give() may be called
};

/// A non-elastic energy in a step.
struct OuterEnergy {
    double EnergyBalance::*part;  ///< part of the balance in which its work is entered
    std::unique_ptr<Energy> energy;
    /// Whether the force depends on the velocity (x - origin) / lag of the step (StepContext), and not on x.
    bool of_velocity;
};

/// The energies of a shell without inertia and contact: elasticity, loads, wind and damping.
class ShellEnergies {
  public:
    /// The shell must outlive this object.
    ShellEnergies(const Shell& shell, const ShellEnergyOptions& options);

    /// Replaces the damping energies by those of `options`, which begin with the shell as it is now.
    void damp(const ShellEnergyOptions& options);

    /// Sets forces on the vertices, [3, V] N, from the next step on: see GivenForces. Only with
    /// ShellEnergyOptions::given_forces.
    void give(const Positions& force) { given->give(force); }

    /// The elastic energies, in the order in which they are summed.
    std::vector<Energy*> elastic() { return {bending.get(), membrane.get(), &mirrors}; }
    const Energy& bending_part() const { return *bending; }
    const Energy& membrane_part() const { return *membrane; }
    /// Energy of mirrors; zero with coupled hinges, whose energy includes it.
    const MirrorEnergy& mirror_part() const { return mirrors; }
    std::vector<Energy*> loads();
    const std::vector<OuterEnergy>& outer() const { return others; }
    /// Whether a clamp or a symmetry plane has a prescribed motion.
    bool mirrors_move() const;

    /// Adds the forces of clamps and symmetry planes, at x [3, V] m in the open step, to the reactions of
    /// their supports.
    void add_mirror_reactions(const Positions& x, std::span<Reaction> of_supports) const;
    /// Work, J, of the clamps and symmetry planes with a prescribed motion, in the step that ends at x.
    double mirror_work(const StepContext& step, const Positions& x) const;
    /// Adds the work of loads, wind and damping in the step that ends at x, [3, V] m, to the balance, and
    /// their gradients at x, N, to `gradient`. moved: displacements of the vertices in the step, [3, V] m.
    void add_outer(const Positions& x, const Positions& moved, EnergyBalance& balance,
                   Positions& gradient) const;

    /// Elastic energy of bending, J.
    double bending_value(const Positions& x) const {
        return bending->value(x) - dissipated_by_yielding(x) + mirrors.value(x);
    }
    /// Energy that bending dissipates by yielding in a step that ends at x, J.
    double dissipated_by_yielding(const Positions& x) const {
        return yielding != nullptr ? yielding->dissipated_by_yielding(x) : 0;
    }
    /// Must be called when a step ends at x: stores the plastic curvatures.
    void store_plastic_curvature(const Positions& x) {
        if (yielding != nullptr) yielding->store_plastic_curvature(x);
    }
    const CoupledBending* coupled_bending() const { return coupled; }  ///< null if hinges are not coupled
    /// Changes of curvature of all faces (CoupledBending::curvatures()); none: hinges are not coupled.
    std::optional<Eigen::Matrix3Xd> coupled_curvatures(const Positions& x) const;
    /// Changes of curvature of all faces, [3, F] 1/m: of coupled hinges, or, if hinges are not coupled, from
    /// curvatures_of_hinges() with angles shared by height.
    Eigen::Matrix3Xd face_curvatures(const Positions& x) const;
    /// Plastic curvatures of all faces (CoupledBending::plastic_curvatures()); none: nothing yields.
    std::optional<Eigen::Matrix3Xd> plastic_curvatures(const Positions& x) const;
    /// Green strain of all faces, [3, F], as the membrane measures it.
    Eigen::Matrix3Xd face_strains(const Positions& x) const;
    // Variants for `faces` only, with a column for each of them.
    std::optional<Eigen::Matrix3Xd> coupled_curvatures(const Positions& x,
                                                       std::span<const Index> faces) const;
    std::optional<Eigen::Matrix3Xd> plastic_curvatures(const Positions& x,
                                                       std::span<const Index> faces) const;
    Eigen::Matrix3Xd face_strains(const Positions& x, std::span<const Index> faces) const;
    double membrane_value(const Positions& x) const { return membrane->value(x); }  ///< J

    void visit_state(StateVisitor& visit);

  private:
    std::vector<Reaction> mirror_reactions(const Positions& x) const;  ///< reaction of each mirror

    const Shell& shell;
    std::unique_ptr<Energy> bending;
    const CoupledBending* coupled;  ///< the bending energy, if its hinges are coupled
    CoupledBending* yielding;       ///< the bending energy, if coupled hinges yield
    std::unique_ptr<Energy> membrane;
    const ArcMembrane* arcs;  ///< membrane, if its sides are arcs
    MirrorEnergy mirrors;
    std::vector<Index> mirror_supports;  ///< ShellEnergyOptions::mirror_supports
    std::vector<Index> mirror_scripts;   ///< MirrorHinge::script of each mirror
    std::vector<OuterEnergy> others;     ///< loads, wind and damping, as far as there are any
    GivenForces* given = nullptr;        ///< the entry of `others`, if there is one
};

}  // namespace sherd
