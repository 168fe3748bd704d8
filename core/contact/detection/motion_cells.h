// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// Cells of a few vertices that are near each other. The boxes of their motions give a cheap bound on the
/// relative motion of any two of many vertices.
class MotionCells {
  public:
    /// Assigns cells to the vertices at x [3, V] m that have none. The first time, vertices near each other
    /// share a cell; later each new vertex has one of its own, since these are few.
    void cover(const Positions& x);
    Index of(Index vertex) const { return cell[vertex]; }
    /// Bounding box, for each cell, of the motions [3, V] m of its vertices.
    std::vector<Box> boxes(const Positions& motions) const;

    void visit_state(StateVisitor& visit) {
        auto& [cell, count] = *this;
        visit(cell, count);
    }

  private:
    std::vector<Index> cell;  ///< cell of each vertex
    Index count = 0;
};

/// Bound, m, on the relative motion of two points whose motions are in a box.
double spread(const Box& motions);

}  // namespace sherd
