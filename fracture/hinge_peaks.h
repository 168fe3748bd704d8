// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/hinge_measures.h"

namespace sherd {

/// The largest that each hinge has borne at the end of a step, before anything broke in it.
class HingePeaks {
  public:
    /// Takes down what the hinges bear in the step that is being solved, instead of what was taken down of an
    /// earlier attempt at it.
    void judge(const BreakableSheet& sheet, const HingeMeasures& measures);
    /// That step is done.
    void finish_step();

    /// [E] in the order of the unbroken mesh's edges, whatever has failed since; 0 where there was no hinge.
    const HingeMeasures& of_edges() const { return peaks; }

  private:
    HingeMeasures attempt, peaks;
};

}  // namespace sherd
