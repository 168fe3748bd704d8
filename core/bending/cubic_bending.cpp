// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_bending.h"

namespace sherd {

CubicHinges::CubicHinges(const std::vector<HingeStencil>& stencils, const Positions& rest, double scale,
                         bool cubic_part)
    : HingeElements{&stencils, &rest, {}}, scale(scale), cubic_part(cubic_part) {
    for (std::size_t i = 0; i < stencils.size(); ++i) hinges.push_back(made(i));
}

CubicHinge CubicHinges::made(std::size_t i) const {
    return cubic_hinge(at_rest(i), scale * (*stencils)[i].stiffness);
}

void CubicHinges::follow(const ShellChange& change) {
    follow_hinges(change, hinges, [this](Index hinge) { return made(hinge); });
}

HingeHessian CubicHinges::hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
    return sherd::hessian(hinges[i], x, cubic_part && curvature == Curvature::exact);
}

CubicHinges2007::CubicHinges2007(const std::vector<HingeStencil>& stencils, const Positions& rest,
                                 bool cubic_part)
    : HingeElements{&stencils, &rest, {}}, cubic_part(cubic_part) {
    for (std::size_t i = 0; i < stencils.size(); ++i) {
        hinges.push_back(cubic_hinge_2007(at_rest(i), stencils[i].stiffness));
        in_equilibrium.push_back(cubic_hinge(at_rest(i), stencils[i].stiffness));
    }
}

HingeHessian CubicHinges2007::hessian(std::size_t i, const HingePositions& x, Curvature curvature) const {
    if (curvature == Curvature::convex) return sherd::hessian(in_equilibrium[i], x, false);
    return sherd::hessian(hinges[i], x, cubic_part);
}

void CubicHinges2007::follow(const ShellChange& change) {
    follow_hinges(change, hinges, [this](Index hinge) {
        return cubic_hinge_2007(at_rest(hinge), (*stencils)[hinge].stiffness);
    });
    follow_hinges(change, in_equilibrium,
                  [this](Index hinge) { return cubic_hinge(at_rest(hinge), (*stencils)[hinge].stiffness); });
}

}  // namespace sherd
