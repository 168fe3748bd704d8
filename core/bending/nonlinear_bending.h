// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/hinge_elements.h"
#include "core/bending/nonlinear_hinge.h"

namespace sherd {

/// The nonlinear hinges of a shell.
struct NonlinearHinges : HingeElements<NonlinearHinge> {
    /// rest: [3, V] m, see HingeElements.
    NonlinearHinges(const std::vector<HingeStencil>& stencils, const Positions& rest)
        : HingeElements{&stencils, &rest, {}} {
        for (std::size_t i = 0; i < stencils.size(); ++i) hinges.push_back(made(i));
    }
    NonlinearHinge made(std::size_t i) const { return nonlinear_hinge(at_rest(i), (*stencils)[i].stiffness); }
    void follow(const ShellChange& change) {
        follow_hinges(change, hinges, [this](Index hinge) { return made(hinge); });
    }
    HingeHessian hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
        return sherd::hessian(hinges[i], x, curvature == Curvature::convex);
    }
};

using NonlinearBending = HingeEnergy<NonlinearHinges>;

}  // namespace sherd
