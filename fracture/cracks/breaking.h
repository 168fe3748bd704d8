// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"
#include "fracture/shell/hinge_measures.h"

namespace sherd {

/// The rule by which overloaded hinges fail.
enum class BreakingRule {
    staged,  ///< in each stage, hinges that are the most overloaded within two rings fail; then the step is
             ///< solved again
    paper    ///< all overloaded hinges fail at the end of the step (paper, section 6)
};

/// Returns the overload of the hinge of `edge`, which is its measure over its strength: a hinge is overloaded
/// above 1. Returns 0 if the edge has no hinge. crack_tips: whether the strength of a hinge that would
/// continue a crack is reduced, because the crack tip concentrates strain more than the mesh resolves.
double overload(const BreakableShell& shell, const HingeMeasure& measure, Edge edge, bool crack_tips);
double overload(const BreakableShell& shell, const HingeMeasures& measures, Edge edge, bool crack_tips);

/// Overload of the most overloaded hinge; 0 without hinges. crack_tips: see overload().
double largest_overload(const BreakableShell& shell, const HingeMeasures& measures, bool crack_tips);

/// Whether the hinge of an edge of a sheet without toughness bears more than half its strength. crack_tips:
/// see overload().
bool bears_half(const BreakableShell& shell, const HingeMeasures& measures, bool crack_tips);

/// The edges that fail in one stage of staged breaking, ascending: each is overloaded, and more so than all
/// other edges within two rings around it. Of equally overloaded edges, the one with the lowest number fails.
/// If all overloaded hinges failed at once, as in the paper, the surroundings of a contact would turn to
/// dust: the strain around a new crack must be evaluated before the next edges fail. Edges of sheets with a
/// toughness are left out, since CrackGrowth breaks them.
std::vector<Edge> most_overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures);

/// All overloaded edges, ascending: the paper's rule, which does not reduce the strength at crack tips. Edges
/// of sheets with a toughness are left out here, too.
std::vector<Edge> overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures);

}  // namespace sherd
