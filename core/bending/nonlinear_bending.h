// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/hinge_elements.h"
#include "core/bending/nonlinear_hinge.h"

namespace sherd {

/// The nonlinear hinges of a shell.
struct NonlinearHinges : HingeElements<NonlinearHinge> {
    /// rest: [3, V] m.
    NonlinearHinges(const std::vector<HingeStencil>& stencils, const Positions& rest)
        : HingeElements{&stencils, {}} {
        for (const HingeStencil& stencil : stencils)
            hinges.push_back(nonlinear_hinge(columns(rest, stencil.vertices), stencil.stiffness));
    }
    HingeHessian hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
        return sherd::hessian(hinges[i], x, curvature == Curvature::convex);
    }
};

using NonlinearBending = HingeEnergy<NonlinearHinges>;

}  // namespace sherd
