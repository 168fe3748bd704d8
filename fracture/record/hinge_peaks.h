// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/shell/hinge_measures.h"

namespace sherd {

/// The largest measures of each hinge in all steps so far. In each step they are taken before anything fails.
class HingePeaks {
  public:
    /// Records the measures in the step that is being solved. They replace the measures of an earlier attempt
    /// at this step.
    void record(const BreakableShell& shell, const HingeMeasures& measures);
    /// Makes the recorded measures final, when the step is finished.
    void finish_step();

    /// Largest measures in the order of edges, [E0 or more]: of all edges of the unfractured mesh, failed
    /// edges included, and of later edges up to the last one that has had a hinge; 0 for edges that never had
    /// a hinge.
    const HingeMeasures& of_edges() const { return peaks; }

    void visit_state(StateVisitor& visit) {
        auto& [attempt, peaks] = *this;
        visit(attempt, peaks);
    }

  private:
    HingeMeasures attempt, peaks;
};

}  // namespace sherd
