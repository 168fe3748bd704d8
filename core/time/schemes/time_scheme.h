// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/rigid_body.h"
#include "core/shell/shell.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/step_context.h"

namespace sherd {

/// An implicit time scheme whose steps end at the minimum of a potential: see StepContext and Inertia.
struct TimeScheme {
    virtual ~TimeScheme() = default;
    /// The step of `length` (s) that begins at `time` (s) with the current state of the shell and the bodies.
    virtual StepContext begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                              double length) = 0;
    /// Applies a change of the shell to the scheme's history and to the origins of the open step.
    virtual void topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) = 0;
    /// Ends the step: sets the shell's positions to x, [3, V] m, and its velocities to the velocities at x.
    virtual void finish(const StepContext& step, const Positions& x, Shell& shell) = 0;
    virtual void visit_state(StateVisitor& /*visit*/) {}
};

}  // namespace sherd
