// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_sheet.h"

namespace sherd {

/// Bending strain of each hinge (paper, appendix B), signed, 1/m, in the order of the mechanics' hinges. x:
/// [3, V] m.
VectorXd hinge_strains(const BreakableSheet& sheet, const Positions& x);

/// What strains the hinges, in the order of the mechanics' hinges, [H] each.
struct HingeMeasures {
    VectorXd bending;  ///< magnitude of the bending strain, 1/m
    VectorXd strain;   ///< tensile strain across the edge at the more stretched surface of the sheet, divided
                       ///< by half the thickness, 1/m
    VectorXd stress;   ///< tensile stress across the edge at the surface where it is larger, Pa

    /// The one that the hinge's sheet is judged by.
    double of(Measure measure, Index hinge) const;
};

/// Strain and stress are means over the edge's two faces of what their Green strain, plus half the thickness
/// times their change of curvature, amounts to across the edge; stress by the membrane's plane-stress
/// elasticity. A face's curvature comes from the change of its hinges' angles. In pure bending `strain` is a
/// curvature, like the paper's measure; unlike that, it sees in-plane stretch, and the bending of a face as a
/// whole. x: [3, V] m.
HingeMeasures hinge_measures(const BreakableSheet& sheet, const Positions& x);

}  // namespace sherd
