// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/cubic_hinge.h"
#include "core/bending/hinge_elements.h"
#include "core/state_visitor.h"

namespace sherd {

/// The cubic hinges of a shell, in equilibrium at rest.
struct CubicHinges : HingeElements<CubicHinge> {
    /// rest: [3, V] m, see HingeElements; scale: factor on the hinges' stiffness; cubic_part: whether the
    /// Hessian includes the cubic part, which is indefinite (the paper's CS), or has only the part of Q (CC).
    CubicHinges(const std::vector<HingeStencil>& stencils, const Positions& rest, double scale = 1,
                bool cubic_part = true);
    HingeHessian hessian(std::size_t i, const HingePositions& x, Curvature curvature) const;
    CubicHinge made(std::size_t i) const;
    void follow(const ShellChange& change);
    void visit_state(StateVisitor& visit) {
        static_assert(
            has_only<CubicHinges, HingeElements<CubicHinge>, decltype(scale), decltype(cubic_part)>());
        HingeElements::visit_state(visit);
    }

    double scale;
    bool cubic_part;
};

/// The cubic hinges of the paper's eq. 7 (cubic_hinge_2007()). For Curvature::convex their Hessian is the
/// matrix Q of the hinges in equilibrium (cubic_hinge()).
struct CubicHinges2007 : HingeElements<CubicHinge> {
    CubicHinges2007(const std::vector<HingeStencil>& stencils, const Positions& rest, bool cubic_part = true);
    HingeHessian hessian(std::size_t i, const HingePositions& x, Curvature curvature) const;
    void follow(const ShellChange& change);
    void visit_state(StateVisitor& visit) {
        static_assert(has_only<CubicHinges2007, HingeElements<CubicHinge>, decltype(in_equilibrium),
                               decltype(cubic_part)>());
        HingeElements::visit_state(visit);
        visit(in_equilibrium);
    }

    std::vector<CubicHinge> in_equilibrium;
    bool cubic_part;
};

using CubicBending = HingeEnergy<CubicHinges>;
using CubicBending2007 = HingeEnergy<CubicHinges2007>;

}  // namespace sherd
