// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_contact.h"
#include "core/forces/vertex_springs.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// Inertia and weight in one implicit step: 1 / (2 lag^2) (x - y)^T M (x - y), where M are the masses and y
/// is the predictor, the positions to which the shell would move without other forces.
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
    double per_mass = 0;  ///< 1/s^2, see hessian_per_mass()
};

/// Inertia and weight of the free bodies in one step: 1 / (2 lag^2) m |q - y|^2 for each body, where m is its
/// mass, q are its columns (BodyColumns) and y the columns of the inertial prediction. Rotations have the
/// inertia tensor at the step's beginning.
class BodyInertia : public ElementEnergy<VertexSprings> {
  public:
    /// bodies: null if there are none; it must outlive this object, and its step must begin first.
    explicit BodyInertia(const BodyContact* bodies) : ElementEnergy({}), bodies(bodies) {}
    void begin(const StepContext& step) override;
    bool has_bodies() const override { return true; }
    Task task() const override { return Task::other; }
    void visit_state(StateVisitor& visit) override {
        static_assert(has_only<BodyInertia, ElementEnergy<VertexSprings>, decltype(bodies)>());
        ElementEnergy::visit_state(visit);
    }

  private:
    const BodyContact* bodies;
};

}  // namespace sherd
