// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_bending.h"

namespace sherd {

CubicHinges::CubicHinges(const std::vector<HingeStencil>& stencils, const Positions& rest, double scale,
                         bool cubic_part)
    : HingeElements{&stencils, {}}, cubic_part(cubic_part) {
    for (const HingeStencil& stencil : stencils)
        hinges.push_back(cubic_hinge(columns(rest, stencil.vertices), scale * stencil.stiffness));
}

HingeHessian CubicHinges::hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
    return sherd::hessian(hinges[i], x, cubic_part && curvature == Curvature::exact);
}

CubicHinges2007::CubicHinges2007(const std::vector<HingeStencil>& stencils, const Positions& rest,
                                 bool cubic_part)
    : HingeElements{&stencils, {}}, cubic_part(cubic_part) {
    for (const HingeStencil& stencil : stencils) {
        const HingePositions local = columns(rest, stencil.vertices);
        hinges.push_back(cubic_hinge_2007(local, stencil.stiffness));
        in_equilibrium.push_back(cubic_hinge(local, stencil.stiffness));
    }
}

HingeHessian CubicHinges2007::hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
    if (curvature == Curvature::convex) return sherd::hessian(in_equilibrium[i], x, false);
    return sherd::hessian(hinges[i], x, cubic_part);
}

void CubicHinges2007::follow(const ShellChange& change) {
    HingeElements::follow(change);
    follow_hinges(change, in_equilibrium);
}

}  // namespace sherd
