// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/contact.h"
#include "core/energy_balance.h"
#include "core/forces/shell_energies.h"

namespace sherd {

/// Keeps the balance of energy of a run, step by step. A step ends in equilibrium of the forces at its end,
/// inertia included. Their work in the step's motion dx is therefore zero in sum, and each gets its account:
/// - inertia, M a . dx, is the change of kinetic energy and what the scheme takes of it (for implicit Euler
///   half the mass times the change of velocity squared);
/// - elasticity and the elastic part of contact, grad U(x1) . dx, are the change of U, what cracks took, and
///   what the scheme takes: U(x0) - U(x1) - grad U(x1) . (x0 - x1), the convexity of U;
/// - loads, wind, damping, friction and supports are work or losses by themselves.
/// What then lacks is that which the minimiser left over, and every fault of the accounts.
class EnergyLedger {
  public:
    /// All must outlive this object. dynamic: whether there is inertia, and weight is a potential; in statics
    /// it is one of the loads.
    EnergyLedger(const Shell& shell, ShellEnergies& forces, Contact& contact, const Vector3d& gravity,
                 bool dynamic)
        : shell(shell), forces(forces), contact(contact), gravity(gravity), dynamic(dynamic) {}

    /// Opens a step, before its energies begin it. A step that is open is discarded.
    void begin(const StepContext& step);
    /// The energies have begun the step.
    void begun();
    /// The step has been solved: x is what a change of the shell will find.
    void solved(const Positions& x) { stored = stored_energy(x); }
    /// The shell and its energies have changed since; x: the same positions, with the new vertices.
    void topology_changed(const Positions& x);
    /// Closes the step at x, after the bodies and before the shell.
    void finish(const StepContext& step, const Positions& x);

    const EnergyBalance& balance() const { return all; }  ///< of the finished steps

  private:
    double elastic_energy(const Positions& x) const {
        return forces.bending_value(x) + forces.membrane_value(x);
    }
    double stored_energy(const Positions& x) const { return elastic_energy(x) + contact.stored_energy(x); }
    double weight(const Positions& x) const;          ///< J, potential energy
    double kinetic(const Positions& velocity) const;  ///< J, with the bodies at the end of the last step
    /// Work of inertia and weight of the shell in the step, and what the scheme takes of it and of the
    /// bodies'; adds the forces to the gradient.
    void add_inertia(const StepContext& step, const Positions& x, EnergyBalance& now,
                     Positions& gradient) const;

    const Shell& shell;
    ShellEnergies& forces;
    Contact& contact;
    Vector3d gravity;
    bool dynamic;
    EnergyBalance all;
    bool started = false;
    double total = 0;     ///< J, kinetic and potential energy at the end of the last step
    double at_rest = 0;   ///< J, stored at the end of the last step
    double at_begin = 0;  ///< J, stored at the beginning of the open step
    double stored = 0;    ///< J, stored when the open step was solved last
    double opened = 0;    ///< J, what edges that opened in the open step stored
};

}  // namespace sherd
