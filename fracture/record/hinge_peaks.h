// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/shell/hinge_measures.h"

namespace sherd {

/// The largest measures of each hinge so far, each taken before anything fails in its step.
class HingePeaks {
  public:
    /// Records the measures in the step that is being solved. They replace those of an earlier attempt at it.
    void record(const BreakableShell& shell, const HingeMeasures& measures);
    /// Makes the recorded measures final, when the step is finished.
    void finish_step();

    /// [E0 or more] in the order of edges: all of the unfractured mesh, failed ones included, and inserted
    /// ones up to the last that had a hinge; 0 for edges that never had one.
    const HingeMeasures& of_edges() const { return peaks; }

    void visit_state(StateVisitor& visit) {
        auto& [attempt, peaks] = *this;
        visit(attempt, peaks);
    }

  private:
    HingeMeasures attempt, peaks;
};

}  // namespace sherd
