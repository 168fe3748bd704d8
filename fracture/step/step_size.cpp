// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/step_size.h"

namespace sherd {

bool StepSize::halve() {
    if (!can_halve()) return false;
    length = std::max(smallest, ticks() / 2);
    successes = 0;
    return true;
}

void StepSize::keep(int halvings) {
    length = ticks_of(halvings);
    is_kept = true;
}

void StepSize::resume() {
    length = whole;
    successes = 0;
    is_kept = false;
}

void StepSize::advance() {
    done += ticks();
    if (is_kept || length == whole) return;
    if (++successes < required_successes || done % (2 * length) != 0) return;
    length *= 2;
    successes = 0;
}

}  // namespace sherd
