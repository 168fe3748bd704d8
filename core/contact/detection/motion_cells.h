// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// Groups vertices into cells of a few vertices that are near each other. The bounding boxes of the
/// displacements of a cell's vertices give a cheap bound on the relative motion of any two vertices of
/// several cells.
class MotionCells {
  public:
    /// Assigns cells to the vertices at x ([3, V] m) that have no cell yet. In the first call, vertices near
    /// each other share a cell; in later calls each new vertex gets a cell of its own, since new vertices are
    /// few.
    void cover(const Positions& x);
    Index of(Index vertex) const { return cell[vertex]; }  ///< number of the vertex's cell
    /// Returns, for each cell, the bounding box of the displacements `motions` ([3, V] m) of its vertices.
    std::vector<Box> boxes(const Positions& motions) const;

    void visit_state(StateVisitor& visit) {
        auto& [cell, count] = *this;
        visit(cell, count);
    }

  private:
    std::vector<Index> cell;  ///< cell of each vertex
    Index count = 0;          ///< number of cells
};

/// Upper bound, m, on the relative motion of two points whose displacements are in the box `motions`.
double spread(const Box& motions);

}  // namespace sherd
