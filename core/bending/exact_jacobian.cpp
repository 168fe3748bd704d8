// SPDX-License-Identifier: GPL-3.0-or-later
// exact_jacobian() has a file of its own, so that code that only reads scenes does not need the energies.
#include "core/bending/bending.h"

namespace sherd {

BendingJacobian exact_jacobian(BendingModel model) {
    const bool cubic = model == BendingModel::cubic || model == BendingModel::cubic_2007;
    return cubic ? BendingJacobian::cubic : BendingJacobian::nonlinear;
}

}  // namespace sherd
