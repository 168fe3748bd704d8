// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/time/kept_forces.h"

namespace sherd {

/// Edges that open gradually in explicit steps, so that each dissipates the energy that its crack requires.
/// When an edge fails, the forces that held it together stay on the vertices, which keep their accelerations.
/// These cohesive forces fade as they dissipate energy: to the share sqrt(1 - W / W_c), where W is their work
/// against the opening and W_c all that they shall dissipate, and to zero after twelve times the time of an
/// opening. Like friction, they never drive a motion. Where the forces of a new edge oppose those left of an
/// earlier one, as after an opening that released energy and one that absorbs it, the two therefore cancel.
class OpeningEdges {
  public:
    /// Adds an edge that fails. kept: [3, V] N, the forces that held it together. gone: J, stored energy that
    /// was lost at once.
    void open(const Opening& edge, Positions kept, double gone);
    /// Reduces the forces after a substep of `length` s in which vertices moved by `moved`, [3, V] m.
    void fade(const Positions& moved, double length);

    /// Adds the present forces to `sum`, N, [3, V].
    void add_forces(Positions& sum) const;
    /// Share of the cohesive force of an edge that still acts; 0 for an open edge.
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
        double needed;     ///< J, to be dissipated by the forces
        double longest;    ///< s, age at which no force is left
        double taken = 0;  ///< J, dissipated by them so far
        double age = 0;    ///< s
        double share = 1;

        /// Removes the opposite parts of these forces and of `others`, [3, V] N; their sum stays.
        void cancel(Positions& others);
        void visit_state(StateVisitor& visit) {
            auto& [edge, kept, needed, longest, taken, age, share] = *this;
            visit(edge, kept, needed, longest, taken, age, share);
        }
    };
    std::vector<Kept> all;
};

}  // namespace sherd
