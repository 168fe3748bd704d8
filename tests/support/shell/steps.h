// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "core/time/schemes/implicit_euler.h"

namespace sherd::test {

/// Step of implicit Euler from the present state of the sheet and the bodies. begin, length: s.
inline StepContext step_of(const Shell& shell, double begin, double length,
                           const std::vector<RigidBody>& bodies = {}) {
    return ImplicitEuler().begin(shell, bodies, begin, length);
}

/// Returns the energy after its begin() for a step of implicit Euler from the present state of the sheet.
/// begin, length: s.
template <class E>
E begun(E energy, const Shell& shell, double begin, double length) {
    energy.begin(step_of(shell, begin, length));
    return energy;
}

/// Makes one step, which must be possible and converge.
inline void advance(ImplicitStepper& stepper) {
    ASSERT_TRUE(stepper.begin());
    ASSERT_TRUE(stepper.solve(200));
    stepper.finish();
}

}  // namespace sherd::test
