// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_sheet.h"

namespace sherd {

/// Bending strain of each hinge (paper, appendix B), signed, 1/m, in the order of the mechanics' hinges. x:
/// [3, V] m.
VectorXd hinge_strains(const BreakableSheet& sheet, const Positions& x);

/// What pulls each hinge's edge open, in the order of the mechanics' hinges: the tensile strain across the
/// edge at the more stretched of the sheet's two surfaces, divided by half the thickness, 1/m. It is the mean
/// over the edge's two faces of (Green strain) / (t / 2) plus the magnitude of that of their change of
/// curvature, both across the edge; a face's curvature comes from the change of its hinges' angles. In pure
/// bending it is a curvature, like the paper's measure; unlike that, it sees in-plane stretch, and the
/// bending of a face as a whole.
VectorXd opening_strains(const BreakableSheet& sheet, const Positions& x);

}  // namespace sherd
