// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/sheet.h"

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

/// Bending energy of all hinges of a sheet. Curvature::exact gives the chosen Jacobian; Curvature::convex the
/// positive semidefinite part of the nonlinear one, or the Q of the cubic hinge in equilibrium.
class BendingEnergy : public Energy {
  public:
    explicit BendingEnergy(const std::vector<HingeStencil>& hinges, const BendingOptions& options = {})
        : hinges(hinges), options(options) {}
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    HingeHessian hinge_hessian(const HingeStencil& hinge, const HingePositions& x, Curvature curvature) const;

    const std::vector<HingeStencil>& hinges;
    BendingOptions options;
};

/// Membrane energy of all triangles of a sheet.
class MembraneEnergy : public Energy {
  public:
    explicit MembraneEnergy(const std::vector<TriangleStencil>& triangles) : triangles(triangles) {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    const std::vector<TriangleStencil>& triangles;
};

}  // namespace sherd
