// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy_balance.h"

namespace sherd {

/// The work of a step.
struct StepWork {
    /// All accounts but those of the ledger: lost_to_scheme has what the scheme takes of the kinetic energy,
    /// and lost_to_cracks what edges take while they open.
    EnergyBalance balance;
    /// Work against the forces of elasticity and contact, less what friction and yielding took of it, J: what
    /// is stored would grow by as much if the forces were those along the way.
    double against_stored = 0;
};

/// Keeps the balance of energy of a run, step by step, from numbers (J) that the stepper has. Stored energy
/// is that of elasticity and contact; the moving energy is kinetic energy and gravity's.
class EnergyLedger {
  public:
    /// Opens a step with what is stored at its beginning. An open step is discarded; what changes of the
    /// shell in it have taken counts as lost to cracks. moving: for the first step.
    void begin(double stored, double moving);
    /// The next step is another scheme's, whose contact may store less, or more, at the same positions: the
    /// scheme takes it.
    void scheme_changed() { is_rebased = true; }
    /// The step has been solved: that much is stored where a change of the shell will find it.
    void solved(double stored) { solution = stored; }
    /// The same of the moving energy, for schemes whose solution has its velocities; else it is that of the
    /// beginning.
    void moves(double moving) { motion = moving; }
    /// The shell has changed since, at the same positions of the sheet: an edge has opened, or it has other
    /// triangles (remeshed). Returns what that took of what was stored, J.
    double topology_changed(double stored, double moving, bool remeshed);
    void finish(const StepWork& work, double stored, double moving);
    /// J, that the scheme takes in the open step, whose work is this.
    double taken_by_scheme(const StepWork& work, double stored) const {
        return work.balance.lost_to_scheme + work.against_stored - (stored - at_begin) - opened - reshaped;
    }

    const EnergyBalance& balance() const { return all; }  ///< of the finished steps

  private:
    EnergyBalance all;
    bool started = false;
    bool is_rebased = false;           ///< whether the next step is the first one of another scheme
    double last = 0, last_moving = 0;  ///< J, stored and moving at the end of the last step
    double at_begin = 0;               ///< J, stored at the beginning of the open step
    double solution = 0;               ///< J, stored when the open step was solved last
    double motion = 0;                 ///< J, moving then, or at the beginning of the open step
    double opened = 0;                 ///< J, what edges that opened in the open step stored
    double reshaped = 0;  ///< J, what other triangles have taken of what was stored in the open step
    double slowed = 0;  ///< J, what changes of triangles have taken of the moving energy since the last step
};

}  // namespace sherd
