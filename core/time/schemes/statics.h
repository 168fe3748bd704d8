// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/schemes/time_scheme.h"

namespace sherd {

/// Statics: the time is the load factor, nothing has inertia, and every step ends at rest. Friction acts
/// against the displacement in a step, as if the step's length were its duration.
struct Statics : TimeScheme {
    StepContext begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                      double length) override;
    void topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) override;
    void finish(const StepContext& step, const Positions& x, Shell& shell) override;
};

}  // namespace sherd
