// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/shell_energies.h"

namespace sherd::test {

/// Gradient of all elastic energies at x, [3, V].
inline Positions elastic_gradient(ShellEnergies& energies, const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    for (const Energy* energy : energies.elastic()) energy->add_gradient(x, sum);
    return sum;
}

}  // namespace sherd::test
