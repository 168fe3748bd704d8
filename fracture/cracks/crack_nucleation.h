// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/hinge_measures.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

/// Nucleation of cracks in sheets that have a toughness. A crack nucleates at a hinge that has been loaded
/// above its strength for long enough: at twice the strength this is twice the time in which a crack crosses
/// the thickness. No crack nucleates near a tip.
class CrackNucleation {
  public:
    /// The shell must outlive this object. timeless: whether nucleation takes no time, as in statics.
    CrackNucleation(const BreakableShell& shell, bool timeless) : shell(shell), timeless(timeless) {}

    /// Returns the edge at which a crack nucleates now, if there is one; of several such edges, the one with
    /// the largest tension across it. waited: s, see CrackEvaluation.
    std::optional<Edge> next(const FaceStrains& strains, const HingeMeasures& measures,
                             std::span<const GrowingTip> tips, double waited);
    /// Time, s, after which a crack may nucleate at the earliest if the stress in the state of the last
    /// next() grew by half at once; infinite if none may.
    double time_left() const { return least_time; }

    void visit_state(StateVisitor& visit) {
        auto& [shell, timeless, exposure, least_time] = *this;
        visit(exposure);  // next() computes least_time
    }

  private:
    /// Stress over strength for nucleation at the hinge of `edge`. Inside a sheet the stress is the principal
    /// tension, since the crack may continue along another edge, at right angles to this tension. At crack
    /// faces and rims, or where strength depends on the direction, the stress is the tension across the edge,
    /// whose ratio to the strength is `across`.
    double ratio(const FaceStrains& strains, double across, Edge edge) const;
    bool near_a_tip(Edge edge, std::span<const GrowingTip> tips) const;

    const BreakableShell& shell;
    bool timeless;
    std::vector<double> exposure;  ///< [E] s, integral of (ratio() - 1)^2 over the time for which the hinge
                                   ///< has been above its strength without interruption
    double least_time = 0;         ///< s, time_left() of the last next()
};

}  // namespace sherd
