// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_sheet.h"
#include "fracture/hinge_measures.h"

namespace sherd {

/// Which overloaded hinges fail, and when.
enum class BreakingRule {
    staged,  ///< in each stage the most overloaded within two rings; then the time step is solved again
    paper    ///< all of them at the end of the time step (paper, section 6)
};

/// What the hinge of `edge` bears over what it withstands; above 1 it is overloaded. Without a hinge: 0.
/// crack_tips: whether a hinge that would continue a crack, whose tip concentrates strain more than a mesh of
/// this coarseness can show, withstands less.
double overload(const BreakableSheet& sheet, const HingeMeasures& measures, Edge edge, bool crack_tips);

/// The edges that fail in one stage of staged breaking: those that are overloaded, and the most so within two
/// rings around them. Breaking all overloaded hinges at once, as the paper does, turns the surroundings of a
/// contact to dust: the strain around a new crack must be judged anew. Ascending; a tie goes to the lower
/// edge.
std::vector<Edge> most_overloaded_edges(const BreakableSheet& sheet, const HingeMeasures& measures);

/// All edges that are overloaded, with no regard to crack tips: the paper's rule. Ascending.
std::vector<Edge> overloaded_edges(const BreakableSheet& sheet, const HingeMeasures& measures);

}  // namespace sherd
