// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/hinge_measures.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

/// Nucleation of cracks in sheets that have a toughness: at a hinge that has been above its strength for as
/// long as a crack needs to cross the thickness, and never near a tip.
class CrackNucleation {
  public:
    /// The shell must outlive this object. timeless: whether nucleation takes no time, as in statics.
    CrackNucleation(const BreakableShell& shell, bool timeless) : shell(shell), timeless(timeless) {}

    /// The edge at which a crack nucleates now; of several the one with the largest tension across it.
    /// waited: s, time since the last call that counts towards nucleation.
    std::optional<Edge> next(const FaceStrains& strains, const HingeMeasures& measures,
                             std::span<const GrowingTip> tips, double waited);

    void visit_state(StateVisitor& visit) {
        auto& [shell, timeless, exposure] = *this;
        visit(exposure);
    }

  private:
    /// Stress over strength for nucleation at a hinge: inside a sheet by the principal tension, since the
    /// crack may start across it along another edge; at crack faces and rims, or where strength depends on
    /// the direction, by the tension across the edge.
    double ratio(const FaceStrains& strains, double across, Edge edge) const;
    bool near_a_tip(Edge edge, std::span<const GrowingTip> tips) const;

    const BreakableShell& shell;
    bool timeless;
    std::vector<double> exposure;  ///< [E] s: time above the strength, times the excess squared
};

}  // namespace sherd
