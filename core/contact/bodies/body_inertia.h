// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_contact.h"

namespace sherd {

/// Inertia and weight of the free bodies in one step, as Inertia has them for the shell: 1 / (2 lag^2)
/// m |q - y|^2 for each body, where q are its columns and y those of the inertial prediction. Rotations have
/// the inertia tensor of the step's beginning.
class BodyInertia : public Energy {
  public:
    /// bodies must outlive this object; its step must begin first.
    explicit BodyInertia(const BodyContact& bodies) : bodies(bodies) {}
    bool has_bodies() const override { return true; }
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    Task task() const override { return Task::other; }
    void visit_state(StateVisitor&) override { [[maybe_unused]] auto& [only] = *this; }

  private:
    const BodyContact& bodies;
};

}  // namespace sherd
