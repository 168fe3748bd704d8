// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "fracture/hinge_measures.h"

namespace sherd {

/// The largest measures of each hinge so far, as they are in each step before anything breaks in it.
class HingePeaks {
  public:
    /// Records the measures in the step that is being solved. They replace those of an earlier attempt at it.
    void judge(const BreakableShell& shell, const HingeMeasures& measures);
    /// Makes the recorded measures final, when the step is finished.
    void finish_step();

    /// In the order of the unbroken mesh's edges, failed ones included, and as far as later edges have
    /// hinges; 0 where there was none.
    const HingeMeasures& of_edges() const { return peaks; }

    void visit_state(StateVisitor& visit) {
        auto& [attempt, peaks] = *this;
        visit(attempt, peaks);
    }

  private:
    HingeMeasures attempt, peaks;
};

}  // namespace sherd
