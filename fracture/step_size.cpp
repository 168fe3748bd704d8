// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step_size.h"

namespace sherd {

bool StepSize::halve() {
    if (!can_halve()) return false;
    ++halvings;
    successes = 0;
    return true;
}

void StepSize::advance() {
    done += ticks();
    if (halvings == 0 || ++successes < enough || done % (2 * ticks()) != 0) return;
    --halvings;
    successes = 0;
}

}  // namespace sherd
