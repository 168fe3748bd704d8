// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// Dead forces on vertices that the caller sets from step to step. They are kept as accelerations: where a
/// crack splits a vertex its copies share the force by their mass, and for inserted or moved vertices the
/// force is interpolated. In statics they grow with the load factor.
class GivenForces : public Energy {
  public:
    /// There are no forces at first. The shell must outlive this object.
    explicit GivenForces(const Shell& shell)
        : shell(shell), acceleration(Positions::Zero(3, shell.position.cols())) {}

    /// Sets the forces, [3, V] N, from the next step on.
    void give(const Positions& forces);
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;  ///< J, zero at the beginning of the step
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions&, Curvature, BlockMatrix&) const override {}  // zero
    Task task() const override { return Task::loads; }
    void visit_state(StateVisitor& visit) override {
        auto& [shell, acceleration, start, force] = *this;
        visit(acceleration);
    }

  private:
    const Shell& shell;
    Positions acceleration;  ///< [3, V] m/s^2
    /// Positions at the beginning of the open step, [3, V] m, and forces in the step, [3, V] N.
    Positions start, force;
};

}  // namespace sherd
