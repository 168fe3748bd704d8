// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/hinge.h"

namespace sherd {

// The triple product [e0, e1, e2] = (e0 x e1) . e2, m^3, of the edges of a hinge from x0 to its other
// vertices: the cubic part of cubic bending energies. It does not change with rigid motion.

double triple_product(const HingePositions& x);

/// Gradient of the triple product, m^2, [3, 4].
HingePositions triple_gradient(const HingePositions& x);

/// Adds factor times the triple product's second derivative, m, [12, 12], coordinate fastest (paper, appendix
/// A). This derivative is linear in x, zero on the diagonal, and not definite.
void add_triple_hessian(double factor, const HingePositions& x, HingeHessian& hessian);

}  // namespace sherd
