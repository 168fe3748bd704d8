// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/growing_tip.h"
#include "fracture/hinge_measures.h"
#include "fracture/surface_stress.h"

namespace sherd {

/// Where cracks are born in sheets that have a toughness: at a hinge that has been over its strength for as
/// long as a crack needs through the thickness, and never near a tip.
class CrackBirth {
  public:
    /// The shell must outlive this object. timeless: in statics, where nothing takes time.
    CrackBirth(const BreakableShell& shell, bool timeless) : shell(shell), timeless(timeless) {}

    /// Of the hinges that fail now, the edge of the one with the most tension across it. waited: s, by which
    /// births have come nearer since the last call.
    std::optional<Edge> next(const FaceStrains& strains, const HingeMeasures& measures,
                             std::span<const GrowingTip> tips, double waited);

    void visit_state(StateVisitor& visit) {
        auto& [shell, timeless, exposure] = *this;
        visit(exposure);
    }

  private:
    /// What a hinge bears over its strength where a crack may be born: within a sheet the principal tension,
    /// since the crack may begin across it along another edge, and at lips and rims, or where strength has
    /// directions, the tension across the edge.
    double ratio(const FaceStrains& strains, double across, Edge edge) const;
    bool near_a_tip(Edge edge, std::span<const GrowingTip> tips) const;

    const BreakableShell& shell;
    bool timeless;
    std::vector<double> exposure;  ///< [E] s: time over the strength, times the square of the excess
};

}  // namespace sherd
