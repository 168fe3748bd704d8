// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/bending/mirror_hinge.h"
#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

class CoupledBending;

/// The bending energy of hinges (paper, sections 3 and 4).
enum class BendingModel {
    coupled,     ///< coupled hinges, which converge to plate theory: see CoupledBending
    cubic,       ///< cubic shell (CS), in equilibrium at rest: see cubic_hinge()
    cubic_2007,  ///< cubic shell of the paper's eq. 7: see cubic_hinge_2007()
    nonlinear    ///< nonlinear hinge (NH)
};

/// The second derivative of bending that Newton's method uses. It affects the number of iterations, but not
/// the solution, which only the energy determines. Coupled hinges always use their own second derivative.
enum class BendingJacobian {
    constant,  ///< the constant Q of the cubic shell, the paper's CC
    cubic,     ///< Jacobian of the cubic shell (appendix A), the paper's CS
    nonlinear  ///< Jacobian of the nonlinear hinge, the paper's NH
};

/// A pair of force model and Jacobian. The paper's are (NH, NH), (NH, CS), (NH, CC), (CS, CS) and (CS, CC).
struct BendingOptions {
    BendingModel model = BendingModel::coupled;
    BendingJacobian jacobian = BendingJacobian::nonlinear;
};

/// The choice that is the Jacobian of the model's own force.
BendingJacobian exact_jacobian(BendingModel model);

/// Makes the bending energy of all hinges of a shell, measured from its rest shape. With coupled hinges it
/// includes the energy of the mirrors, which with the other models is a separate energy (MirrorEnergy). The
/// shell must outlive the energy, and all changes of the shell must be passed to topology_changed().
/// Curvature::exact gives the chosen Jacobian. Curvature::convex gives the positive semidefinite part of the
/// second derivative of nonlinear or coupled hinges, or the matrix Q of cubic hinges in equilibrium.
std::unique_ptr<Energy> bending_energy(const Shell& shell, const BendingOptions& options = {},
                                       const std::vector<MirrorHinge>& mirrors = {});

/// The cubic hinges (cubic_hinge()) that give a bending energy its forces, one for each hinge of the shell;
/// null if other hinges do.
const std::vector<CubicHinge>* cubic_hinges(const Energy& bending);

/// The bending energy as CoupledBending; null if its hinges are not coupled.
const CoupledBending* coupled_hinges(const Energy& bending);

}  // namespace sherd
