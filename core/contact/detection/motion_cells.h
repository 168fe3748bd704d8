// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// Vertices in cells of a few that are near each other. The boxes of their motions bound, for little, how far
/// any two of many vertices move relative to each other.
class MotionCells {
  public:
    /// Puts those at x [3, V] m into cells that have none yet: the first time those near each other together,
    /// later each by itself, since these are few.
    void cover(const Positions& x);
    Index of(Index vertex) const { return cell[vertex]; }
    /// Of each cell the box of the motions [3, V] m of its vertices.
    std::vector<Box> boxes(const Positions& motions) const;

    void visit_state(StateVisitor& visit) {
        auto& [cell, count] = *this;
        visit(cell, count);
    }

  private:
    std::vector<Index> cell;  ///< of each vertex
    Index count = 0;
};

/// Bound, m, on how far any two points move relative to each other whose motions a box has.
double spread(const Box& motions);

}  // namespace sherd
