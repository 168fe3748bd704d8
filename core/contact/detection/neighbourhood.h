// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// The positions within a margin, at each vertex, of some moment of a straight motion. Without colliders, a
/// common translation of all vertices is disregarded since it changes no distance. The set is convex: if it
/// contains the ends of a straight motion, it contains all of it.
class Neighbourhood {
  public:
    Neighbourhood() = default;
    /// x, motion: [3, V] m, the first `colliders` vertices belonging to colliders; margin: m.
    Neighbourhood(const Positions& x, const Positions& motion, double margin, Index colliders = 0);

    bool contains(const Positions& x) const { return contains(x, 0); }
    bool contains(const Neighbourhood& other) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, motion, margin, round_off, colliders, colliders_rest] = *this;
        visit(start, motion, margin, round_off, colliders, colliders_rest);
    }

    Positions start;       ///< [3, V] m
    Positions motion;      ///< m; without colliders, the common translation is subtracted
    double margin = 0;     ///< m
    double round_off = 0;  ///< m, bound on round-off, far above the actual error of any distance

  private:
    bool contains(const Positions& x, double spare) const;

    Index colliders = 0;
    bool colliders_rest = true;  ///< whether the colliders are at rest, so that their vertices need no check
};

}  // namespace sherd
