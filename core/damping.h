// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sheet_energies.h"

namespace sherd {

/// Damping proportional to stiffness and to mass (Rayleigh). A mode of angular frequency w is damped with the
/// ratio (stiffness w + mass / w) / 2.
struct Damping {
    double stiffness = 0;  ///< s; resists changes of shape
    double mass = 0;       ///< 1/s; resists all motion, that of rigid bodies too, like a thick medium
};

/// Stiffness-proportional damping in one implicit Euler step: (stiffness / h) times the elastic energy of a
/// sheet whose rest shape is the one at the beginning of the step. To second order this is Rayleigh's
/// stiffness / (2 h) (x - x_n)^T K (x - x_n), with K that of the sheet's shape at x_n without its stresses.
/// An elastic energy has neither net force nor net torque on any shape: linear and angular momentum are kept,
/// which x^T K x alone does for linear momentum only.
class StiffnessDamping : public Energy {
  public:
    /// sheet.position are the positions at the beginning of the step. coefficient and step: s.
    StiffnessDamping(const Sheet& sheet, double coefficient, double step);
    StiffnessDamping(const StiffnessDamping&) = delete;  // its sums refer to its stencils
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::loads; }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    std::vector<HingeStencil> hinges;
    std::vector<TriangleStencil> triangles;
    BendingEnergy bending;
    MembraneEnergy membrane;
};

/// Mass-proportional damping in one implicit Euler step: coefficient / (2 h) (x - x_n)^T M (x - x_n). It
/// takes linear and angular momentum away, at the rate `coefficient`.
class MassDamping : public Energy {
  public:
    /// sheet.position are the positions at the beginning of the step; the sheet must outlive it.
    /// coefficient: 1/s; step: s.
    MassDamping(const Sheet& sheet, double coefficient, double step)
        : sheet(sheet), scale(coefficient / step) {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::loads; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}

  private:
    const Sheet& sheet;
    double scale;  ///< 1/s^2
};

}  // namespace sherd
