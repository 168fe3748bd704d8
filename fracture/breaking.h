// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_sheet.h"

namespace sherd {

/// The edges that fail in one stage of staged breaking: those whose strain exceeds their strength and whose
/// overload (strain / strength) is the largest within two rings around them. Breaking all overloaded hinges
/// at once, as the paper does, turns the surroundings of a contact to dust: the strain around a new crack
/// must be judged anew. Ascending; a tie goes to the lower edge. strains: see opening_strains(), 1/m.
/// crack_tip_factor: times the strength of a hinge that would continue a crack, whose tip concentrates strain
/// more than a mesh of this coarseness can show.
std::vector<Edge> failing_edges(const BreakableSheet& sheet, const VectorXd& strains,
                                double crack_tip_factor);

}  // namespace sherd
