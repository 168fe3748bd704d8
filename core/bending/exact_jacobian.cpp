// SPDX-License-Identifier: GPL-3.0-or-later
// Apart from the energies, which who only reads a scene does not need.
#include "core/bending/bending.h"

namespace sherd {

BendingJacobian exact_jacobian(BendingModel model) {
    const bool cubic = model == BendingModel::cubic || model == BendingModel::cubic_2007;
    return cubic ? BendingJacobian::cubic : BendingJacobian::nonlinear;
}

}  // namespace sherd
