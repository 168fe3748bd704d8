// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/implicit_euler.h"

namespace sherd {

/// The implicit midpoint rule: forces of elasticity and of velocity are those in the middle of the step,
/// those of contact at its end, so that nothing passes through anything there. It is of second order, damps
/// nothing, and keeps both momenta exactly where nothing touches.
class Midpoint : public TimeScheme {
  public:
    StepContext begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                      double length) override;
    void topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) override {
        euler.topology_changed(shell, change, step);
    }
    void finish(const StepContext& step, const Positions& x, Shell& shell) override {
        euler.finish(step, x, shell);
    }

  private:
    ImplicitEuler euler;  ///< which begins at the same place, and remembers nothing either
};

}  // namespace sherd
