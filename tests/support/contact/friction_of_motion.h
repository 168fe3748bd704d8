// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/sheets/sheet_friction.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd::test {

/// Checks friction in a step `moved` in which an obstacle moves along x: gradient and Hessian must be
/// derivatives of the friction's energy, and its force must pull the sheet along x.
inline void expect_friction_along_x(const Shell& shell, SheetContact& contact, const StepContext& moved) {
    contact.begin(moved);
    SheetFriction friction(shell, contact, 0);
    friction.begin(moved);
    Positions force = Positions::Zero(3, shell.position.cols());
    friction.add_gradient(shell.position, force);
    EXPECT_LT(force.row(0).sum(), 0) << "the energy falls where the sheet follows";
    expect_derivatives(friction, shell.position, 1e-10, 1e-3);
}

}  // namespace sherd::test
