// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"
#include "fracture/shell/hinge_measures.h"

namespace sherd {

/// The rule by which overloaded hinges fail.
enum class BreakingRule {
    staged,  ///< the most overloaded within two rings fail in each stage; then the step is solved again
    paper    ///< all overloaded hinges fail at the end of the step (paper, section 6)
};

/// Overload of the hinge of `edge`: its measure over its strength. The hinge is overloaded above 1; the
/// overload is 0 without a hinge. crack_tips: whether the strength is reduced for a hinge that would continue
/// a crack, because the crack tip concentrates strain more than the mesh resolves.
double overload(const BreakableShell& shell, const HingeMeasure& measure, Edge edge, bool crack_tips);
double overload(const BreakableShell& shell, const HingeMeasures& measures, Edge edge, bool crack_tips);

/// Overload of the most overloaded hinge; 0 without hinges.
double largest_overload(const BreakableShell& shell, const HingeMeasures& measures, bool crack_tips);

/// The edges that fail in one stage of staged breaking: those that are overloaded, and more so than all
/// others within two rings around them. If all overloaded hinges failed at once, as in the paper, the
/// surroundings of a contact would turn to dust: the strain around a new crack must be evaluated again. The
/// edges are ascending; of equally overloaded ones the lowest fails. Sheets with a toughness are left to
/// CrackGrowth.
std::vector<Edge> most_overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures);

/// All overloaded edges, ascending, without regard to crack tips: the paper's rule. Sheets with a toughness
/// are left to CrackGrowth here, too.
std::vector<Edge> overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures);

}  // namespace sherd
