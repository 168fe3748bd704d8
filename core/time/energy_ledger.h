// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy_balance.h"

namespace sherd {

/// The work of a step.
struct StepWork {
    /// All accounts that the ledger does not compute itself, J. Here lost_to_scheme is only the kinetic
    /// energy that the scheme dissipates, and lost_to_cracks only the energy that edges dissipate while they
    /// open.
    EnergyBalance balance;
    /// Work against the forces of elasticity and contact, less the dissipation of friction and yielding, J.
    /// The stored energy would grow by this amount if the work were integrated exactly along the path.
    double against_stored = 0;
};

/// Energy balance of a run, step by step, from energies (J) that the stepper computes. Stored energy is the
/// energy of elasticity and contact; moving energy is kinetic energy plus the potential energy of gravity.
class EnergyLedger {
  public:
    /// Opens a step with the energies at its beginning, and discards an open step. Stored energy that changes
    /// of the shell have removed since the last step counts as lost to cracks; moving energy counts as lost
    /// to remeshing.
    void begin(double stored, double moving);
    /// Must be called when the next step has another scheme or contact stiffness, so that the stored energy
    /// may differ at the same positions. The difference counts as lost to the scheme.
    void scheme_changed() { is_rebased = true; }
    /// Sets the stored energy of the solution, with which topology_changed() compares.
    void solved(double stored) { solution = stored; }
    /// Sets the moving energy of the solution, for schemes whose solution includes velocities; without a
    /// call, the moving energy at the beginning of the step is used.
    void moves(double moving) { motion = moving; }
    /// Must be called when the shell has changed since the solution, at the same positions of the sheet: an
    /// edge has opened, or triangles have been replaced (remeshed). stored, moving: energies after the
    /// change. Returns the stored energy that was lost, J.
    double topology_changed(double stored, double moving, bool remeshed);
    void finish(const StepWork& work, double stored, double moving);
    /// Returns the energy that the scheme dissipates in the open step with this work, J.
    double dissipated_by_scheme(const StepWork& work, double stored) const {
        return work.balance.lost_to_scheme + work.against_stored - (stored - at_begin) - opened - reshaped;
    }

    const EnergyBalance& balance() const { return all; }  ///< sum over the finished steps

  private:
    EnergyBalance all;
    bool started = false;
    bool is_rebased = false;           ///< whether the next step is the first after scheme_changed()
    double last = 0, last_moving = 0;  ///< J, stored and moving energy at the end of the last step
    double at_begin = 0;               ///< J, stored energy at the beginning of the open step
    double solution = 0;               ///< J, stored energy when the open step was solved last
    double motion = 0;                 ///< J, moving energy set by moves(), or at the beginning of the step
    double opened = 0;                 ///< J, stored energy lost to edges that opened in the open step
    double reshaped = 0;               ///< J, stored energy lost to remeshing in the open step
    double slowed = 0;                 ///< J, moving energy lost to remeshing since the last step
};

}  // namespace sherd
