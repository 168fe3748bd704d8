// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/schemes/time_scheme.h"

namespace sherd {

/// Implicit Euler: it is of first order, keeps no history, and damps all vibrations.
struct ImplicitEuler : TimeScheme {
    StepContext begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                      double length) override;
    void topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) override;
    void finish(const StepContext& step, const Positions& x, Shell& shell) override;
};

}  // namespace sherd
