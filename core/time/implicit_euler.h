// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/time_scheme.h"

namespace sherd {

/// Implicit Euler: it is of first order, keeps no history, and damps all vibrations.
struct ImplicitEuler : TimeScheme {
    StepContext begin(const Sheet& sheet, const std::vector<RigidBody>& bodies, double time,
                      double length) const override;
    void topology_changed(const Sheet& sheet, const ShellChange& change, StepContext& step) override;
    void finish(const StepContext& step, const Positions& x, Sheet& sheet) override;
};

}  // namespace sherd
