// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/energy.h"
#include "core/shell/sheet.h"

namespace sherd {

/// The bending energy of a hinge (paper, sections 3 and 4).
enum class BendingModel {
    cubic,       ///< cubic shell (CS), in equilibrium at rest: see cubic_hinge()
    cubic_2007,  ///< cubic shell as printed in the paper: see cubic_hinge_2007()
    nonlinear    ///< nonlinear hinge (NH)
};

/// The second derivative of bending that Newton's method gets. Only the energy says where the step ends; this
/// says how many iterations it takes to get there.
enum class BendingJacobian {
    constant,  ///< Q of the cubic shell, the paper's CC
    cubic,     ///< of the cubic shell (appendix A), the paper's CS
    nonlinear  ///< of the nonlinear hinge, the paper's NH
};

/// A pairing of force and Jacobian. The paper's are (NH, NH), (NH, CS), (NH, CC), (CS, CS) and (CS, CC).
struct BendingOptions {
    BendingModel model = BendingModel::cubic;
    BendingJacobian jacobian = BendingJacobian::cubic;
};

/// The derivative of the model's own force.
BendingJacobian exact_jacobian(BendingModel model);

/// Bending energy of all hinges of a shell, from its rest shape. The shell must outlive it, and tell it of
/// its changes by topology_changed(). Curvature::exact gives the chosen Jacobian; Curvature::convex the
/// positive semidefinite part of the nonlinear one, or the Q of the cubic hinge in equilibrium.
std::unique_ptr<Energy> bending_energy(const Sheet& sheet, const BendingOptions& options = {});

}  // namespace sherd
