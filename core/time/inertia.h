// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/vertex_springs.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// Inertia and weight in one implicit step: 1 / (2 lag^2) (x - y)^T M (x - y), where y is the predictor, to
/// which the shell would move without other forces.
class Inertia : public ElementEnergy<VertexSprings> {
  public:
    /// The shell must outlive this object. gravity: m/s^2.
    Inertia(const Shell& shell, const Vector3d& gravity)
        : ElementEnergy({}), shell(shell), gravity(gravity) {}
    void begin(const StepContext& step) override;
    double hessian_per_mass() const override { return per_mass; }
    Task task() const override { return Task::other; }

    /// Predictor y, m, [3, V]; for fixed vertices, their positions at the end of the step.
    const Positions& predicted() const { return elements.anchor; }
    void visit_state(StateVisitor& visit) override {
        static_assert(has_only<Inertia, ElementEnergy<VertexSprings>, decltype(shell), decltype(gravity),
                               decltype(per_mass)>());
        ElementEnergy::visit_state(visit);
    }

  private:
    const Shell& shell;
    Vector3d gravity;
    double per_mass = 0;  ///< 1/s^2
};

}  // namespace sherd
