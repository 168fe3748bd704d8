// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/time/kept_forces.h"

namespace sherd {

/// Edges that open gradually in explicit steps, so that each takes the energy that its crack needs. When an
/// edge fails, what held it together stays as forces on the vertices, which keep their accelerations. These
/// forces fade as they take energy: to the share sqrt(1 - W / W_c), with their work W against the opening and
/// all that they shall take, W_c, and to nothing after twelve times the time of an opening. They act as
/// friction does: never as a motor. So where what held an edge opposes what is kept of one before, as after
/// an opening that gave energy and the next that takes it away, the two cancel.
class OpeningEdges {
  public:
    /// kept: [3, V] N, what held the edge together. gone: J, that went out of what is stored at once.
    void open(const Opening& edge, Positions kept, double gone);
    /// Lets the forces fade over a substep of `length` s in which vertices moved by `moved`, [3, V] m.
    void fade(const Positions& moved, double length);

    /// The forces now, N; as many columns as vertices.
    void add_forces(Positions& sum) const;
    /// Share of what held an edge together that still does; 0 for one that has opened.
    double held(Index edge) const;
    bool empty() const { return all.empty(); }
    void visit_state(StateVisitor& visit) {
        auto& [all] = *this;
        visit(all);
    }

  private:
    struct Kept {
        Index edge;
        KeptForces kept;
        double needed;     ///< J, that they shall take
        double longest;    ///< s
        double taken = 0;  ///< J, that they have taken
        double age = 0;    ///< s
        double share = 1;

        /// Takes out of both what is opposed in these forces and `others`, [3, V] N: their sum stays.
        void cancel(Positions& others);
        void visit_state(StateVisitor& visit) {
            auto& [edge, kept, needed, longest, taken, age, share] = *this;
            visit(edge, kept, needed, longest, taken, age, share);
        }
    };
    std::vector<Kept> all;
};

}  // namespace sherd
