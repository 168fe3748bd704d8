// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/energy_ledger.h"

namespace sherd {

void EnergyLedger::begin(double stored, double moving) {
    if (!started) {
        started = true;
        last = stored;
        last_moving = moving;
    }
    if (is_rebased) {
        all.lost_to_scheme += last - stored;
        last = stored;
        is_rebased = false;
    }
    at_begin = stored;
    opened = reshaped = 0;
    motion = moving;
    slowed = last_moving - moving;
}

double EnergyLedger::topology_changed(double stored, double moving, bool remeshed) {
    const double gone = solution - stored;
    (remeshed ? reshaped : opened) += gone;
    solution = stored;
    slowed += motion - moving;
    motion = moving;
    return gone;
}

void EnergyLedger::finish(const StepWork& work, double stored, double moving) {
    EnergyBalance now = work.balance;
    now.lost_to_scheme = dissipated_by_scheme(work, stored);
    now.lost_to_cracks += opened + last - at_begin;
    now.lost_to_remeshing += reshaped + slowed;
    const double gained = now.work_of_loads + now.work_of_wind + now.work_of_supports + now.work_of_obstacles;
    const double lost = now.lost_to_friction + now.lost_to_damping + now.lost_to_cracks +
                        now.lost_to_remeshing + now.lost_to_yield + now.lost_to_scheme;
    now.unexplained = stored + moving - (last + last_moving) - gained + lost;
    last = stored;
    last_moving = moving;
    all += now;
}

}  // namespace sherd
